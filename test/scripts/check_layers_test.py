#!/usr/bin/python3
"""Tests of scripts/check_layers and of the outline that it reads."""

import importlib.util
import pathlib
import sys
import unittest
from importlib.machinery import SourceFileLoader

SCRIPTS = pathlib.Path(__file__).resolve().parents[2] / "scripts"
sys.path.insert(0, str(SCRIPTS))
sys.dont_write_bytecode = True
loader = SourceFileLoader("check_layers", str(SCRIPTS / "check_layers"))
spec = importlib.util.spec_from_loader("check_layers", loader)
check_layers = importlib.util.module_from_spec(spec)
loader.exec_module(check_layers)

MULTI_LINE = """namespace rovio_sfm {
// What { a comment } says.
std::vector<int> Sum(const std::map<int, int>& a,
                     int b = 3) {
  if (a.empty()) {
    return {"}", '{'};
  }
BODY}

Thing::Thing(int a)
    : a_(a), b_{a} {
  Run([](int c) { return c; });
}
}  // namespace rovio_sfm
"""


def include(name):
    return f'#include "rovio_sfm/{name}.h"\n'


class Outline(unittest.TestCase):
    def test_counts_a_function_from_its_signature(self):
        outline = check_layers.read_outline(MULTI_LINE.replace("BODY", ""))
        self.assertEqual([(f.scope, f.name, f.first_line, f.last_line) for f in outline.functions],
                         [("", "Sum", 3, 8), ("Thing", "Thing", 10, 13)])

    def test_sees_members_classes_and_anonymous_namespaces(self):
        outline = check_layers.read_outline(
            "namespace {\nclass A {\n public:\n  int Get() const { return 1; }\n};\n}\n"
            "constexpr int kList[] = {1, 2};\nbool operator==(A a, A b) { return true; }\n")
        self.assertEqual([(f.scope, f.name, f.is_hidden) for f in outline.functions],
                         [("A", "Get", True), ("", "operator==", False)])
        self.assertEqual(outline.classes, ["A"])


class Lengths(unittest.TestCase):
    def breaches(self, name, text):
        return list(check_layers.check_length(name, name, text))

    def test_refuses_a_long_function_whose_signature_has_two_lines(self):
        self.assertEqual(self.breaches("a.cc", MULTI_LINE.replace("BODY", "  Add();\n" * 34)), [])
        found = self.breaches("a.cc", MULTI_LINE.replace("BODY", "  Add();\n" * 35))
        self.assertEqual(found, ["a.cc:3: Sum has 41 lines, more than 40"])

    def test_lets_one_class_fill_350_lines_but_nothing_else(self):
        one = "void A::Run() {}\n" * 350
        self.assertEqual(self.breaches("a.cc", one), [])
        self.assertEqual(len(self.breaches("a.cc", one + "void A::Run() {}\n")), 1)
        self.assertEqual(len(self.breaches("a.cc", one[:-17] + "void B::Run() {}\n")), 1)
        self.assertEqual(len(self.breaches("a.cc", "void Run() {}\n" * 301)), 1)


class Rings(unittest.TestCase):
    def test_refuses_a_ring_over_header_and_source(self):
        texts = [("sfm/a.h", include("sfm/b")), ("sfm/b.cc", include("sfm/b") + include("sfm/c")),
                 ("sfm/c.h", include("sfm/a")), ("sfm/d.h", include("sfm/a"))]
        self.assertEqual(list(check_layers.check_rings(texts)),
                         ["these include each other in a ring: sfm/a, sfm/b, sfm/c"])

    def test_lets_a_diamond_be(self):
        texts = [("sfm/a.cc", include("sfm/b") + include("sfm/c")), ("sfm/b.h", include("sfm/d")),
                 ("sfm/c.h", include("sfm/d")), ("sfm/d.h", "")]
        self.assertEqual(list(check_layers.check_rings(texts)), [])


class Includes(unittest.TestCase):
    def test_refuses_an_include_upwards(self):
        found = list(check_layers.check_includes("sfm/a.cc", include("app/mapper")))
        self.assertEqual(found, ["sfm/a.cc: sfm must not include rovio_sfm/app/mapper.h"])


if __name__ == "__main__":
    unittest.main()
