"""The lines about recognising places."""

import hashlib
import json
import subprocess

from acceptance.common import (BUILD, DEVEL, MODEL, PROGRAMS, ROOT, WORK, Skipped, dataset, fresh_folder,
                               render_tour, run)

TRAINING_SEEDS = (1, 2, 3)
TRAINING_SOURCES = ("src/features/*.cc", "src/places/*.cc", "src/tools/train*.cc", "include/rovio_sfm/features/*.h",
                    "include/rovio_sfm/places/*.h")
NOISE = 10
FIRST_LAP = 95


def evaluate(name, queries, database, distractors, *options):
    """summary.json of evaluate_places, with its curve as PNG beside it."""
    program = PROGRAMS / "evaluate_places"
    if not program.exists():
        raise Skipped("evaluate_places is not built")
    out = fresh_folder(f"places/{name}")
    run(program, "--query", *queries, "--database", *database, "--distractors", *distractors, "--out", out,
        *options)
    run(ROOT / "scripts/plot_places.py", out / "curves.csv", out / "curves.png")
    return json.loads((out / "summary.json").read_text())


def model_options(model=MODEL):
    return ("--model", model) if model else ()


def figures(curve):
    return (f"precision {curve['precision']:.3f}, recall {curve['recall']:.3f}, area "
            f"{curve['area_under_curve']:.3f}, recall at 100 % precision "
            f"{curve['recall_at_full_precision']:.3f}")


def turntable2(_quick):
    folder = render_tour("turntable2", NOISE, 1)
    distractors = [dataset("leuven_castle"), render_tour("engineRoom0", NOISE, 1),
                   dataset("strecha_fountain_p11")]
    s = evaluate("turntable2", [f"{folder}@{FIRST_LAP}:188"], [f"{folder}@0:{FIRST_LAP - 1}"], distractors,
                 "--truth", "overlaps", *model_options())
    after = s["fabmap_verified"]
    return after["precision"] >= 0.98 and after["recall"] >= 0.89, (
        f"{s['queries_with_positive']} of {s['queries']} queries have a true place; before geometry: "
        f"{figures(s['fabmap'])}; after: {figures(after)}")


def fr1(_quick):
    distractors = [dataset("leuven_castle"), render_tour("engineRoom0", NOISE, 1),
                   render_tour("visionlab", NOISE, 1)]
    summaries = [evaluate(f"fr1_seed{seed}", [dataset("tum_fr1_rpy")], [dataset("tum_fr1_xyz")], distractors,
                          "--truth", "poses", "--stride", 5, *model_options(trained_model(seed)))
                 for seed in TRAINING_SEEDS]
    holds, parts = True, []
    for name, text in (("area_under_curve", "area"), ("recall_at_95_precision", "recall at 95 %"),
                       ("strict_area_under_curve", "strict area")):
        ours, theirs = (sum(s[method][name] for s in summaries) / len(summaries)
                        for method in ("fabmap", "tf_idf"))
        holds = holds and ours >= theirs
        parts.append(f"{text} {ours:.3f}, tf-idf {theirs:.3f}")
    for seed, s in zip(TRAINING_SEEDS, summaries):
        after = s["fabmap_verified"]
        holds = holds and after["precision"] >= 0.95 and after["recall"] >= 0.90
        parts.append(f"training seed {seed} after geometry: precision {after['precision']:.3f}, recall "
                     f"{after['recall']:.3f}")
    return holds, "; ".join(parts)


def trained_model(seed):
    """Trained as the shipped one was, with another seed; kept while what it is made of stays."""
    if seed == 1 and (MODEL or (ROOT / "config/places/indoor.places").exists()):
        return MODEL
    model, photographs = WORK / f"places/seed{seed}.places", dataset("indoor_train_doordetect") / "images"
    mark = model.with_suffix(".fingerprint")
    fingerprint = training_fingerprint(photographs, seed)
    if not model.exists() or not mark.exists() or mark.read_text() != fingerprint:
        model.parent.mkdir(parents=True, exist_ok=True)
        fresh = model.with_name(f"{model.stem}.{fingerprint[:12]}.places")  # its own --resume
        run(PROGRAMS / "train_places", photographs, "--out", fresh, "--seed", seed, "--resume",
            timeout_s=4 * 3600)
        fresh.rename(model)
        mark.write_text(fingerprint)
    return str(model)


def training_fingerprint(photographs, seed):
    """Of everything that a model depends on: the source of the training, the photographs, the seed."""
    digest = hashlib.sha256(f"{seed}".encode())
    sources = [path for pattern in TRAINING_SOURCES for path in ROOT.glob(pattern)]
    for path in (*sorted(sources), *sorted(photographs.iterdir())):
        digest.update(path.name.encode() + hashlib.sha256(path.read_bytes()).digest())
    return digest.hexdigest()


def scale(_quick):
    """The benchmarks of places at scale, and their plot."""
    program = PROGRAMS / "benchmarks"
    if not program.exists():
        raise Skipped("benchmarks is not built")
    out = fresh_folder("places_scale")
    out.mkdir()
    file = out / "figures.json"
    run(program, "--benchmark_filter=QueryPlaces|WalkPostings|PassOverPlaces", f"--benchmark_out={file}",
        "--benchmark_out_format=json")
    run(ROOT / "scripts/plot_places_scale.py", file, out / "scale.png")
    queries = {int(b["name"].split("/")[1]): b for b in json.loads(file.read_text())["benchmarks"]
               if b["name"].startswith("QueryPlaces/")}
    bounds_ms = {1000: 20, 10000: 22, 100000: 40}
    holds = all(n in queries and queries[n]["cpu_time"] <= bound and queries[n]["bytes_per_place"] <= 1500
                for n, bound in bounds_ms.items())
    parts = [f"{n} places: {b['cpu_time']:.1f} {b['time_unit']}, {b['bytes_per_place']:.0f} bytes each"
             for n, b in sorted(queries.items())]
    return holds, "; ".join(parts) + f"; {out / 'scale.png'}"


def node_tests(_quick):
    """The node tests of place_recognition, which restart it in the middle."""
    done = subprocess.run([str(DEVEL / "env.sh"), "ctest", "-R", "place_recognition",
                           "--output-on-failure"], cwd=BUILD, capture_output=True, text=True, check=False)
    found = "No tests were found" not in done.stdout + done.stderr
    tail = [line.strip() for line in done.stdout.splitlines() if line.strip()][-4:]
    return done.returncode == 0 and found, " ".join(tail)
