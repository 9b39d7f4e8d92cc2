"""Makes the wheel and the source archive for pip and other build front ends (PEP 517). Needs no package and no network. Equal sources
always give equal files."""
import base64
import gzip
import hashlib
import io
import pathlib
import re
import tarfile
import zipfile

HERE = pathlib.Path(__file__).parent
NAME = "javino"
EPOCH = (1980, 1, 1, 0, 0, 0)
_BESIDES = ("LICENSE", "README.md", "build_wheel.py", "package.json", "pyproject.toml")


def _version():
    return re.search(r'__version__ = "(.*)"', (HERE / NAME / "__init__.py").read_text()).group(1)


def _sources():
    return sorted((HERE / NAME).glob("*.py"))


def _metadata():
    return (f"Metadata-Version: 2.1\nName: {NAME}\nVersion: {_version()}\n"
            "Summary: Boards in Python that agents sense and act through, in the Javino protocol\n"
            "License: Apache-2.0\nRequires-Python: >=3.8\nProvides-Extra: serial\nRequires-Dist: pyserial; extra == 'serial'\n"
            "Description-Content-Type: text/markdown\n\n" + (HERE / "README.md").read_text())


def get_requires_for_build_wheel(config_settings=None):
    """Returns no requirements."""
    return []


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    """Writes the wheel into the directory. Returns the wheel's file name."""
    info = f"{NAME}-{_version()}.dist-info"
    files = {f"{NAME}/{path.name}": path.read_bytes() for path in _sources()}
    files[f"{info}/METADATA"] = _metadata().encode()
    files[f"{info}/WHEEL"] = b"Wheel-Version: 1.0\nGenerator: javino\nRoot-Is-Purelib: true\nTag: py3-none-any\n"
    files[f"{info}/LICENSE"] = (HERE / "LICENSE").read_bytes()
    record = ""
    for name, data in files.items():
        digest = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()
        record += f"{name},sha256={digest},{len(data)}\n"
    files[f"{info}/RECORD"] = f"{record}{info}/RECORD,,\n".encode()
    wheel = f"{NAME}-{_version()}-py3-none-any.whl"
    with zipfile.ZipFile(pathlib.Path(wheel_directory) / wheel, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, data in files.items():
            archive.writestr(zipfile.ZipInfo(name, EPOCH), data, zipfile.ZIP_DEFLATED)
    return wheel


def build_sdist(sdist_directory, config_settings=None):
    """Writes the source archive into the directory. Returns the archive's file name."""
    top = f"{NAME}-{_version()}"
    files = {path.relative_to(HERE).as_posix(): path.read_bytes()
             for path in _sources() + [HERE / each for each in _BESIDES]}
    files["PKG-INFO"] = _metadata().encode()
    packed = io.BytesIO()
    with gzip.GzipFile(fileobj=packed, mode="wb", mtime=0) as file, tarfile.open(fileobj=file, mode="w") as archive:
        for name, data in files.items():
            entry = tarfile.TarInfo(f"{top}/{name}")
            entry.size = len(data)
            archive.addfile(entry, io.BytesIO(data))
    (pathlib.Path(sdist_directory) / f"{top}.tar.gz").write_bytes(packed.getvalue())
    return f"{top}.tar.gz"
