#include "rovio_sfm/app/write_page.h"

#include <fstream>
#include <sstream>
#include <stdexcept>

#include "rovio_sfm/util/package_file.h"

namespace rovio_sfm {
namespace {

constexpr char kThree[] = "/usr/share/javascript/three/";

std::string ReadText(const std::filesystem::path& path, const std::string& package) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  if (file && !text.str().empty()) return text.str();
  throw std::runtime_error("report: " + path.string() + ": cannot be read; it comes with " +
                           package);
}

std::string OwnText(const std::string& name) {
  const auto path = FindPackageFile("config/page/" + name);
  if (path) return ReadText(*path, "rovio_sfm");
  throw std::runtime_error("report: config/page/" + name + ": not found beside this program");
}

// Nothing in a script may look like its end.
std::string InScript(std::string text) {
  for (size_t at = text.find("</"); at != std::string::npos; at = text.find("</", at + 3)) {
    text.replace(at, 2, "<\\/");
  }
  return text;
}

void Fill(const std::string& mark, const std::string& text, std::string* page) {
  const size_t at = page->find(mark);
  if (at == std::string::npos) throw std::runtime_error("report: page.html: no " + mark);
  page->replace(at, mark.size(), text);
}

void Put(const std::string& mark, const std::string& text, std::string* page) {
  Fill("<!-- " + mark + " -->\n", text, page);
}

// is_live: with the parts of the page that map_web alone has.
std::string FillPage(const std::string& data_json, bool is_live) {
  const std::string three = ReadText(std::string(kThree) + "three.min.js", "libjs-three");
  const std::string controls =
      ReadText(std::string(kThree) + "examples/js/controls/OrbitControls.js", "libjs-three");
  std::string page = OwnText("page.html");
  Put("live.html", is_live ? OwnText("live.html") : "", &page);
  Put("live.js", is_live ? "<script>\n" + OwnText("live.js") + "</script>\n" : "", &page);
  Fill("/* style.css */", OwnText("style.css"), &page);
  Fill("/* viewer.js */", OwnText("viewer.js"), &page);
  Fill("/* charts.js */", OwnText("charts.js"), &page);
  Fill("/* data */", InScript(data_json), &page);
  Fill("/* OrbitControls */", InScript(controls), &page);
  Fill("/* three */", InScript(three), &page);
  return page;
}

}  // namespace

std::string PageText(const std::string& data_json) { return FillPage(data_json, false); }

std::string LivePageText(const std::string& settings_json) { return FillPage(settings_json, true); }

}  // namespace rovio_sfm
