"""Lanchester: shaking forces and moments of piston engines from one engine file.

>>> import lanchester
>>> twin = lanchester.Engine.template("twin-360")
>>> found = twin.balance(minimise="force", counterweights="throws")
>>> found.outcome.kind
'optimal'
"""

from . import _version  # noqa: F401  refuses a Python that is too old, before the compiled part is loaded
from . import results
from ._native import VERSION as __version__
from ._record import Picture, Record, Records, Result
from .engine import Engine, Variants, adopt, compare, map
from .errors import Diagnostic, EngineFileError, InternalError, LanchesterError, RequestError
from .sheet import WorkshopSheet
from .table import Table

__all__ = [
    "Diagnostic",
    "Engine",
    "EngineFileError",
    "InternalError",
    "LanchesterError",
    "Picture",
    "Record",
    "Records",
    "RequestError",
    "Result",
    "Table",
    "Variants",
    "WorkshopSheet",
    "__version__",
    "adopt",
    "compare",
    "map",
    "results",
]
