"""The comparison as Markdown."""

AS_MANY = "ours, as many features"  # as COLMAP hurried has, where that is more than it was told
HEAD = ("| images | system | features | registered | maps | landmarks | projections | per landmark | per image "
        "| RMS, px | RMS_N | error, cm | CPU, s | wall, s | peak, MB |\n" + "|---" * 15 + "|\n")


def number(value, digits=0):
    return "–" if value is None else f"{value:.{digits}f}"


def share(a, b):
    return a / b if a is not None and b else None


def row(name, system, num_images, result):
    error_cm = None if result["error_m"] is None else 100 * result["error_m"]
    cost = result["cost"]
    return ("| " + " | ".join([
        name, system, number(result["features"]), f"{result['registered']} of {num_images}", str(result["maps"]),
        str(result["landmarks"]), str(result["projections"]),
        number(share(result["projections"], result["landmarks"]), 1),
        number(share(result["projections"], result["registered"])), number(result["rms_px"], 2),
        number(result["rms_n"], 2), number(error_cm, 2), number(cost["cpu_s"], 1), number(cost["wall_s"], 1),
        number(cost["peak_mb"])]) + " |\n")


def ratio_row(name, ours, theirs, title):
    """Ours over theirs; CPU time the other way round: how many times faster."""
    def ratio(key):
        return number(share(ours[key], theirs[key]), 2)
    faster = number(share(theirs["cost"]["cpu_s"], ours["cost"]["cpu_s"]), 1)
    return (f"| {name} | {title} | {ratio('features')} | {ratio('registered')} | | {ratio('landmarks')} "
            f"| {ratio('projections')} | | | {ratio('rms_px')} | {ratio('rms_n')} | {ratio('error_m')} "
            f"| {faster} × faster | | |\n")


def markdown(sets):
    """sets: as scripts/compare writes them to JSON."""
    text = HEAD
    for entry in sets:
        for title, ours in entry["ours"].items():
            text += row(entry["name"], title, entry["num_images"], ours)
        for title, theirs in entry["colmap"].items():
            text += row(entry["name"], title, entry["num_images"], theirs)
            for our_title, ours in entry["ours"].items():
                if our_title in theirs["compare_with"]:
                    text += ratio_row(entry["name"], ours, theirs, f"{our_title} / {title}")
    return text
