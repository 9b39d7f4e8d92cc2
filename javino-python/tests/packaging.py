#!/usr/bin/env python3
"""Builds and installs the package with pip, without a network. Checks that two wheels are equal and that all modules are installed."""
import ast
import json
import pathlib
import subprocess
import sys
import tempfile
import venv

ROOT = pathlib.Path(__file__).resolve().parent.parent
HOSTS_ONLY = {"hosts.py"}  # modules only for computers


def run(*command, cwd=None):
    done = subprocess.run(command, cwd=cwd, capture_output=True, text=True)
    if done.returncode:
        raise AssertionError(f"{command} failed\n{done.stdout}{done.stderr}")
    return done.stdout


def check(condition, what):
    if not condition:
        raise AssertionError(what)


def wheels(python, folder):
    for name in ("a", "b"):
        run(python, "-m", "pip", "wheel", "-q", "--no-deps", "--no-index", "-w", folder / name, ROOT)
    first, second = [next((folder / name).glob("javino-*.whl")) for name in ("a", "b")]
    check(first.read_bytes() == second.read_bytes(), "two wheels of the same sources differ")
    return first


def main():
    # The package for microcontrollers leaves out modules for computers.
    listed = json.loads((ROOT / "package.json").read_text())
    expected = sorted(f"javino/{path.name}" for path in (ROOT / "javino").glob("*.py") if path.name not in HOSTS_ONLY)
    check([each[0] for each in listed["urls"]] == expected, f"package.json should list {expected}")
    check(f'__version__ = "{listed["version"]}"' in (ROOT / "javino/__init__.py").read_text(), "package.json has another version")
    check(f"<version>{listed['version']}</version>" in (ROOT.parent / "pom.xml").read_text(), "pom.xml has another version")
    check((ROOT / "LICENSE").read_text() == (ROOT.parent / "LICENSE").read_text(), "the licence differs from the repository's")
    for path in [*(ROOT / "javino").glob("*.py"), *(ROOT / "examples").glob("*.py")]:
        ast.parse(path.read_text(), feature_version=(3, 8))
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        venv.create(folder / "env", with_pip=True)
        python = folder / "env/bin/python"
        wheel = wheels(python, folder)
        run(python, "-m", "pip", "install", "-q", "--no-index", wheel)
        found = run(python, "-c", "import javino, javino.hosts, javino.rules; print(javino.__file__, javino.__version__)", cwd=folder)
        check(str(folder / "env") in found and found.split()[1] == listed["version"], found)
        check("License: Apache-2.0" in run(python, "-m", "pip", "show", "javino"), "pip does not know the licence")
        sys.path.insert(0, str(ROOT))
        import build_wheel
        check(build_wheel.build_sdist(folder) == f"javino-{listed['version']}.tar.gz", "no source archive")
        sources = folder / f"javino-{listed['version']}.tar.gz"
        run(python, "-m", "pip", "wheel", "-q", "--no-deps", "--no-index", "-w", folder / "c", sources)
        print(f"  wheel: {wheel.stat().st_size} bytes")


if __name__ == "__main__":
    main()
