"""What the package computes with. It may change at any time: call the package instead."""

from typing import Optional

import numpy as np
import numpy.typing as npt

_Rows = npt.NDArray[np.float64]
_Asked = tuple[_Rows, _Rows, tuple[bool, list[int], list[int]]]
_Looking = tuple[Optional[float], Optional[int]]
_Figures = tuple[float, float, float, float, float]
_Path = list[tuple[float, float, float]]

__version__: str

def presets() -> list[tuple[str, str, str, npt.NDArray[np.float64]]]: ...
def encode(scene: str) -> str: ...
def decode(link: str) -> str: ...
def checked(rows: _Rows, probabilities: Optional[list[float]]) -> Optional[list[float]]: ...
def attractor(
    rows: _Rows, probabilities: Optional[list[float]], points: int, seed: int
) -> tuple[npt.NDArray[np.float32], npt.NDArray[np.uint8]]: ...
def rasterize(
    rows: _Rows,
    probabilities: Optional[list[float]],
    options: tuple[
        int,
        int,
        Optional[tuple[float, float, float]],
        str,
        list[tuple[int, int, int]],
        bool,
        float,
        Optional[bool],
        bool,
    ],
) -> npt.NDArray[np.uint8]: ...
def bounds(rows: _Rows) -> tuple[list[float], list[float], npt.NDArray[np.float64]]: ...
def dimension(rows: _Rows) -> tuple[Optional[float], float]: ...
def connectedness(
    rows: _Rows, asked: _Looking
) -> tuple[
    str,
    tuple[float, float],
    list[tuple[int, int]],
    list[int],
    int,
    Optional[list[list[float]]],
    float,
    int,
    Optional[str],
]: ...
def certificate(rows: _Rows, asked: _Looking) -> Optional[str]: ...
def connected_certificate(rows: _Rows, asked: _Looking) -> Optional[str]: ...
def check(certificate: str) -> tuple[bool, str, int, int, int]: ...
def pair(
    first: tuple[_Rows, Optional[list[float]]], last: tuple[_Rows, Optional[list[float]]]
) -> tuple[npt.NDArray[np.float64], npt.NDArray[np.float64], list[float], list[float], list[str]]: ...
def interpolate(
    asked: _Asked,
    probabilities: Optional[tuple[list[float], list[float]]],
    at: tuple[float, float, float],
) -> tuple[npt.NDArray[np.float64], Optional[list[float]]]: ...
def locus(
    asked: _Asked, bounds: list[float], size: tuple[int, int], epsilon: float, w: float
) -> tuple[npt.NDArray[np.uint8], npt.NDArray[np.float32]]: ...
def plan_path(
    asked: _Asked, epsilon: float, size: Optional[int], space: bool
) -> tuple[list[list[float]], float, bool, float, Optional[list[float]], bool, float]: ...
def check_path(
    asked: _Asked, path: _Path, epsilon: float, samples: int
) -> tuple[float, bool, list[tuple[float, float]]]: ...
def certify_path(
    asked: _Asked,
    path: _Path,
    within: float,
    stretch: tuple[float, float],
    budget: Optional[int],
) -> tuple[float, bool, int, float, bool, int]: ...
def trace(
    pixels: npt.NDArray[np.uint8], size: tuple[int, int], threshold: float, stalk: bool, component: int
) -> tuple[npt.NDArray[np.float64], float, float, list[tuple[str, str]]]: ...
def measure(outline: _Rows) -> tuple[npt.NDArray[np.float64], float, float, float]: ...
def fit_numbers(
    outline: _Rows, numbers: int
) -> tuple[
    npt.NDArray[np.float64],
    list[Optional[tuple[int, int, bool, float]]],
    npt.NDArray[np.float64],
    _Figures,
    int,
]: ...
def fit_bytes(
    outline: _Rows, bytes: int
) -> tuple[str, bytes, int, int, npt.NDArray[np.float64], _Figures]: ...
