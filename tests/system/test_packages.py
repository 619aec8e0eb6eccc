#!/usr/bin/env python3
"""share/apt-packages.txt lists exactly the packages that the build, the scripts and the tests use;
share/slurm/apt-packages.txt lists those that only Slurm needs.
Run by ctest as test_packages.py ROOT."""

import re
import sys
import unittest
from pathlib import Path

from slurm_cluster import PROGRAMS as PROGRAMS_OF_THE_CLUSTER

# Names for find_package(), and the Debian packages that provide them.
OF_PACKAGE = {
    "benchmark": {"libbenchmark-dev"},
    "Eigen3": {"libeigen3-dev"},
    "GTest": {"libgtest-dev"},
    "benchmark": {"libbenchmark-dev"},
    "mrpt-gui": {"libmrpt-gui-dev", "libgl1-mesa-dri"},
    "mrpt-hwdrivers": {"libmrpt-hwdrivers-dev"},
    "mrpt-maps": {"libmrpt-maps-dev"},
    "mrpt-nav": {"libmrpt-nav-dev"},
    "mrpt-obs": {"libmrpt-obs-dev"},
    "mrpt-opengl": {"libmrpt-opengl-dev", "libgl1-mesa-dri"},
    "mrpt-tclap": {"libmrpt-tclap-dev"},
    "nanoflann": {"libnanoflann-dev"},
    "nlohmann_json": {"nlohmann-json3-dev"},
    "OpenCV": {"libopencv-dev"},
    "OpenGL": {"libopengl-dev", "libegl-dev"},
    "OpenMP": {"build-essential"},
    "sdformat12": {"libsdformat-dev"},
    "OpenSSL": {"libssl-dev"},
    "Python3": {"python3"},
    "tinyxml2": {"libtinyxml2-dev"},
    "ZLIB": {"zlib1g-dev"},
    "flownav": set(),  # the consumer's: ourselves
}
# Programs called by the scripts of share/slurm and by the cluster that tests them.
OF_SLURM = {
    "munged": {"munge"},
    "sbatch": {"slurm-client"},
    "scontrol": {"slurm-client"},
    "sinfo": {"slurm-client"},
    "slurmctld": {"slurmctld"},
    "slurmd": {"slurmd"},
    "squeue": {"slurm-client"},
}
# Programs called by scripts, by find_program() and by ctest, and files for find_file(). Programs without a
# package are part of every Debian.
OF_PROGRAM = {
    "ccache": {"ccache"},
    "chromedriver": {"chromium-driver"},
    "chromium": {"chromium"},
    "clang-tidy": set(),  # of the preset `tidy` only, for those who develop
    "cmake": {"cmake", "ninja-build"},  # every preset uses Ninja
    "ctest": {"cmake"},
    "dygraph.min.css": {"libjs-dygraphs"},
    "dygraph.min.js": {"libjs-dygraphs"},
    "g++": {"build-essential"},
    "isa-l": {"libisal-dev"},
    "libavfilter": {"libavfilter-dev"},
    "libavformat": {"libavformat-dev"},
    "libswscale": {"libswscale-dev"},
    "parallel": {"parallel"},
    "python3": {"python3"},
    "rawlog-edit": {"mrpt-apps"},
    "rawlog-grabber": {"mrpt-apps"},
    "valgrind": {"valgrind"},
    "xdotool": {"xdotool"},
    "Xvfb": {"xvfb"},
    "sudo": set(),  # only where one is not root; looked for first
}
EVERYWHERE = "apt-get awk cat chmod dirname dpkg-query env grep id ln mkdir mktemp mv nproc realpath rm rmdir sed tr"
OF_PROGRAM |= {name: set() for name in [*EVERYWHERE.split(), *OF_SLURM]}  # those of Slurm have a list of their own
# Modules imported by the Python scripts, except Python's own.
OF_MODULE = {"numpy": {"python3-numpy"}, "cv2": {"python3-opencv"}, "selenium": {"python3-selenium"}}
# System folders read by the tests.
OF_FOLDER = {"/usr/share/mrpt": {"mrpt-common"}}

SHELL_WORDS = set(
    "[ [[ ] ]] { } ! if then elif else fi for in do done while until case esac function select time "
    "cd command continue break echo eval exec exit export false local mapfile printf read return set shift "
    "source . test trap true unset usage wait".split()
)


def packages_listed(text):
    return [name for name in (line.split("#")[0].strip() for line in text.splitlines()) if name]


def cmake_needs(text):
    """Returns (names of packages, names of programs and files) that a CMake file looks for."""
    code = re.sub(r"#.*", "", text)
    packages = set(re.findall(r"\bfind_(?:package|dependency)\(\s*([\w-]+)", code))
    programs = set(re.findall(r"\bfind_(?:program|file)\(\s*\w+\s+(?:NAMES\s+)?([\w.+-]+)", code))
    return packages, programs


def programs_called(script):
    """Returns the first word of every command in a shell script; ignores here-documents and commands in variables."""
    code = re.sub(r"<<-?\s*['\"]?(\w+)['\"]?.*?\n\1\n", "\n", script + "\n", flags=re.DOTALL)
    code = re.sub(r"(^|\s)#.*", r"\1", code)
    code = re.sub(r"\\\n", " ", code)
    code = re.sub(r"\$\(\(.*?\)\)", "", code)  # arithmetic
    substituted = re.findall(r"\$\(\s*(?!\()([^\s()]+)", code)  # also those inside strings
    functions = set(re.findall(r"^\s*(\w+)\s*\(\)", code, re.MULTILINE))
    code = re.sub(r"'[^']*'", "''", code)
    code = re.sub(r'"\$\{\w+\[@\]\}"', "", code)
    code = re.sub(r'"(?:\\.|\$\([^()]*\)|[^"\\])*"', '""', code)
    code = re.sub(r"\$\([^()]*\)", "", code)
    code = re.sub(r"\w+\+?=\([^()]*\)", "", code)  # lists
    code = re.sub(r"^\s*[\w*|. -]+\)", "", code, flags=re.MULTILINE)  # the patterns of case
    before_command = r"(?:[{!]|\b(?:if|then|elif|else|do|while|until|exec|time)\s|\w+=\S*)"
    commands = []
    for part in re.split(r"\n|;|&&|\|\||\||<\(|[()]", code):
        words = re.sub(rf"^\s*(?:{before_command}\s*)*", "", part).split()
        commands += words[:1]
    named = {word for word in commands + substituted if re.fullmatch(r"[A-Za-z][\w+.-]*", word)}
    return named - SHELL_WORDS - functions


def modules_imported(text):
    names = re.findall(r"^\s*(?:import|from)\s+(\w+)", text, re.MULTILINE)
    return set(names) - set(sys.stdlib_module_names)


def folders_read(text):
    return set(re.findall(r'"(/usr/share/[\w-]+)', text))


def unknown_and_needed(names, table):
    unknown = sorted(names - set(table))
    needed = set().union(*(table[name] for name in names if name in table))
    return unknown, needed


class Packages(unittest.TestCase):
    ROOT = Path(__file__).resolve().parents[2]

    def files(self, *patterns):
        found = [self.ROOT / "CMakeLists.txt"] if "CMakeLists.txt" in patterns else []
        for folder in ("libs", "apps", "tests", "share"):
            for pattern in patterns:
                found += sorted((self.ROOT / folder).rglob(pattern))
        return found

    def texts(self, *patterns):
        return [file.read_text() for file in self.files(*patterns)]

    def needs(self):
        """Returns four sets of names used in the tree: packages searched for, programs called, modules imported,
        folders read."""
        packages, programs, modules, folders = set(), {"cmake", "ctest", "g++", "python3"}, set(), set()
        for text in self.texts("CMakeLists.txt", "*.cmake", "*.cmake.in"):
            more_packages, more_programs = cmake_needs(text)
            packages |= more_packages
            programs |= more_programs
        for text in self.texts("*.sh", "*.sbatch"):
            programs |= programs_called(text)
        own = {file.stem for file in self.files("*.py")}
        for text in self.texts("*.py"):
            modules |= modules_imported(text) - own
        for text in self.texts("*.cpp", "*.h"):
            folders |= folders_read(text)
        return packages, programs, modules, folders

    def test_the_list_is_what_the_tree_needs(self):
        listed = packages_listed((self.ROOT / "share/apt-packages.txt").read_text())
        self.assertEqual(len(listed), len(set(listed)), "a package is listed twice")
        needed = set()
        for names, table in zip(self.needs(), (OF_PACKAGE, OF_PROGRAM, OF_MODULE, OF_FOLDER)):
            unknown, more = unknown_and_needed(names, table)
            self.assertEqual(unknown, [], "unknown to this test: map it to its Debian package")
            needed |= more
        self.assertEqual(sorted(needed - set(listed)), [], "missing in share/apt-packages.txt")
        self.assertEqual(sorted(set(listed) - needed), [], "listed in share/apt-packages.txt, but not needed")

    def test_the_list_for_slurm_is_what_its_scripts_and_their_test_need(self):
        listed = packages_listed((self.ROOT / "share/slurm/apt-packages.txt").read_text())
        called = set(PROGRAMS_OF_THE_CLUSTER)
        for text in self.texts("*.sh", "*.sbatch"):
            called |= programs_called(text) & set(OF_SLURM)
        self.assertEqual(sorted(listed), sorted(unknown_and_needed(called, OF_SLURM)[1]))

    def test_the_scripts_are_looked_into(self):
        programs = self.needs()[1]
        self.assertLessEqual({"apt-get", "cmake", "ctest", "dpkg-query", "nproc", "sbatch", "scontrol"}, programs)

    def test_calls_are_found_wherever_they_stand(self):
        script = """#!/bin/bash
            # comment one
            two=$(three --a) && four | five -x || six
            if seven; then eight; fi
            echo "nine $(ten eleven)" 'twelve; thirteen'
            for i in fourteen; do fifteen; done
            X=1 sixteen < <(seventeen)
            \tcat <<END
            eighteen
END
            own() { nineteen; }
            own; "$root/own.sh"; "${list[@]}" twenty
            case $x in
                a | -b) twenty-one ;;
            esac
            list=(no no) && list+=("no")
            sum=$((no < two ? no : two)) "$((no + 1))"
        """
        expected = "three four five six seven eight ten fifteen sixteen seventeen cat nineteen twenty twenty-one".split()
        self.assertEqual(programs_called(script), set(expected))

    def test_what_cmake_looks_for_is_found(self):
        text = "# find_package(no)\nfind_package(GTest REQUIRED)\nfind_program(X\n  rawlog-edit REQUIRED)\nfind_file(Y a.min.js)"
        self.assertEqual(cmake_needs(text), ({"GTest"}, {"rawlog-edit", "a.min.js"}))


if __name__ == "__main__":
    if len(sys.argv) > 1:
        Packages.ROOT = Path(sys.argv.pop(1))
    unittest.main()
