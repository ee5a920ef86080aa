"""What Python expects of a package: threads, Ctrl-C, pickles, notebooks, stubs and docstrings."""

from __future__ import annotations

import ast
import doctest
import inspect
import pickle
import struct
import subprocess
import sys
import threading
import zlib
from pathlib import Path

import frond
import numpy as np
import pytest
from asked import ROOT

FOLDER = Path(frond.__file__).parent


def test_other_threads_go_on() -> None:
    """A thread that counts gets to count while a locus is computed."""
    counted = 0
    done = threading.Event()

    def count() -> None:
        nonlocal counted
        while not done.wait(0.001):
            counted += 1

    thread = threading.Thread(target=count)
    thread.start()
    before = counted
    frond.connectedness("koch", 1e-13, budget=3_000_000)
    frond.presets()["koch"].rasterize(2000, 2000)
    after = counted
    done.set()
    thread.join()
    assert after > before


STOPPED = """
import frond, signal, threading
morph = frond.Morph("fern", "tree")
for work in (
    lambda: frond.locus(morph, width=4000, height=4000),
    lambda: frond.plan_path(morph, size=1000, axes=3),
):
    threading.Timer(0.3, signal.raise_signal, [signal.SIGINT]).start()
    try:
        work()
    except KeyboardInterrupt:
        print("stopped")
"""


@pytest.mark.skipif(sys.platform == "win32", reason="there signals are others")
def test_ctrl_c_is_heard() -> None:
    done = subprocess.run([sys.executable, "-c", STOPPED], capture_output=True, text=True, check=True)
    assert done.stdout.split() == ["stopped"] * 2


def test_pickles() -> None:
    weighted = frond.Ifs(frond.presets()["fern"], [1, 2, 3, 4])
    morph = frond.Morph("fern", weighted, mode="linear", turns=[0, 1, 0, 0])
    again = pickle.loads(pickle.dumps(morph))
    assert again.at(0.3, 0.7) == morph.at(0.3, 0.7)
    preset = pickle.loads(pickle.dumps(frond.presets()["fern"]))
    assert (preset.id, preset) == ("fern", frond.presets()["fern"])
    assert pickle.loads(pickle.dumps(frond.FrondError("no", "code"))).code == "code"
    assert len({weighted, frond.Ifs(weighted), preset}) == 2


def pixels_of(png: bytes) -> np.ndarray:
    """What a PNG shows, read by hand."""
    assert png[:8] == b"\x89PNG\r\n\x1a\n"
    width, height = struct.unpack(">II", png[16:24])
    at, packed = 8, b""
    while at < len(png):
        (length,) = struct.unpack(">I", png[at : at + 4])
        kind, content = png[at + 4 : at + 8], png[at + 8 : at + 8 + length]
        assert struct.unpack(">I", png[at + 8 + length : at + 12 + length]) == (zlib.crc32(kind + content),)
        packed += content if kind == b"IDAT" else b""
        at += 12 + length
    rows = np.frombuffer(zlib.decompress(packed), np.uint8).reshape(height, 1 + 4 * width)
    assert not rows[:, 0].any()
    return rows[:, 1:].reshape(height, width, 4)


def test_a_notebook_shows_a_picture() -> None:
    fern = frond.presets()["fern"]
    png = fern._repr_png_()
    assert png is not None
    np.testing.assert_array_equal(pixels_of(png), fern.rasterize(480, 360))


def test_arrays_are_as_told() -> None:
    fern = frond.presets()["fern"]
    picture = fern.rasterize(7, 5)
    assert (picture.shape, picture.dtype) == ((5, 7, 4), np.uint8)
    assert fern.rasterize(0, 5).shape == (5, 0, 4)
    assert fern.attractor(0).positions.shape == (0, 2)
    assert picture.flags.writeable
    # Row 0 is on top: y points up.
    flat = frond.Ifs([(0.5, 0), (0.5, 0.5), (0.5, 0.25 + 1j)]).rasterize(200, 200)[:, :, 3] > 0
    assert flat[:100].sum() < flat[100:].sum()
    low, high = fern.bounds().min, fern.bounds().max
    points = fern.attractor(1000).positions
    assert (points >= low - 1e-4).all()
    assert (points <= high + 1e-4).all()


def test_everything_public_is_told() -> None:
    for name in frond.__all__:
        value = getattr(frond, name)
        if name == "STATES":
            continue
        assert inspect.getdoc(value), name
        for key, member in vars(value).items() if inspect.isclass(value) else ():
            if not key.startswith("_") and (inspect.isfunction(member) or isinstance(member, property)):
                assert inspect.getdoc(member), f"{name}.{key}"


def test_parts_are_told() -> None:
    """`help` does not show what stands below a field: the docstring of its class has it."""
    for value in (frond.Box, frond.Check, frond.Locus, frond.Path, frond.PathProof, frond.Points, frond.Verdict):
        for field in value.__annotations__:
            assert f"\n{field} : " in (inspect.getdoc(value) or ""), (value, field)


def test_names_are_those_that_are_imported() -> None:
    with pytest.raises(frond.FrondError) as caught:
        frond.Ifs(5)
    assert f"{caught.type.__module__}.{caught.type.__qualname__}" == "frond.FrondError"
    version = (ROOT / "Cargo.toml").read_text().split('\nversion = "')[1].split('"')[0]
    assert frond.__version__ == version


def test_what_is_raised_is_told() -> None:
    for name in ("connectedness", "certificate", "check", "locus", "plan_path", "certify_path", "link", "Ifs", "Morph"):
        assert "FrondError" in (inspect.getdoc(getattr(frond, name)) or ""), name


def test_examples_of_docstrings() -> None:
    tried = 0
    for module in [frond, *(value for key, value in sys.modules.items() if key.startswith("frond._"))]:
        failed, count = doctest.testmod(module, extraglobs=vars(frond))
        assert failed == 0
        tried += count
    assert tried > 5


def test_the_stub_is_that_of_the_module() -> None:
    """The names and the arguments of `_frond.pyi` are those of the library."""
    stub = ast.parse((FOLDER / "_frond.pyi").read_text())
    told = {
        node.name: [argument.arg for argument in (*node.args.posonlyargs, *node.args.args)]
        for node in stub.body
        if isinstance(node, ast.FunctionDef)
    }
    library = sys.modules["frond._frond"]
    there = {
        name: list(inspect.signature(value).parameters)
        for name, value in vars(library).items()
        if callable(value) and not name.startswith("_")
    }
    assert told == there
    assert (FOLDER / "py.typed").is_file()


def blocks(path: Path) -> list[str]:
    """The Python of a page, block by block."""
    return [part.split("```")[0] for part in path.read_text().split("```python\n")[1:]]


@pytest.mark.parametrize("page", ["docs/python.md", "crate/python/README.md"])
def test_pages_run_as_they_stand(page: str, tmp_path: Path) -> None:
    """One block after the other, in one program."""
    found = blocks(ROOT / page)
    assert found
    program = "\n".join(found)
    done = subprocess.run(
        [sys.executable, "-W", "error", "-c", program], capture_output=True, text=True, cwd=tmp_path, check=False
    )
    assert done.returncode == 0, done.stderr
    for line in (line.split("# ", 1)[1] for line in program.splitlines() if line.startswith("print(") and "# " in line):
        assert line in done.stdout.splitlines(), line
