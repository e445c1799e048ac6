"""Arrestor Prediction Code: aircraft in crushable arrestor beds.

    import apc
    run = apc.simulate("B737-800", "emas_18in_50psi", "70 kt", braking=0.25)
    run.stop_distance, run.gears.nose.peak_drag, run.history.distance

Quantities go in as text with a unit ("70 kt", "66 t") or as numbers in SI; everything comes out in SI, histories and
columns as NumPy arrays. Results are dicts whose keys can also be read as attributes.
"""

import functools

from . import _apc
from ._apc import Bed, InputError, SolveError, __version__, load_bed

__all__ = ["Bed", "InputError", "Record", "SolveError", "design", "load_bed", "reliability", "report", "simulate", "study"]


class Record(dict):
    """A dict whose keys can be read as attributes."""

    def __getattr__(self, name):
        try:
            return self[name]
        except KeyError:
            raise AttributeError(f"no {name!r} here; there are: {', '.join(map(str, self))}") from None

    def __dir__(self):
        return [*super().__dir__(), *map(str, self)]


def _recorded(value):
    if isinstance(value, dict):
        return Record((key, _recorded(each)) for key, each in value.items())
    if isinstance(value, list):
        return [_recorded(each) for each in value]
    return value


def _wrapped(call):
    @functools.wraps(call)
    def wrapper(*arguments, **named):
        return _recorded(call(*arguments, **named))

    return wrapper


simulate = _wrapped(_apc.simulate)
study = _wrapped(_apc.study)
design = _wrapped(_apc.design)
reliability = _wrapped(_apc.reliability)
report = _wrapped(_apc.report)
