"""The values that the fields of a statement may have: quantities, states, and conditions of curves
and loads.
"""

import re
from typing import Annotated, Any

from pydantic import (
    AfterValidator,
    BaseModel,
    BeforeValidator,
    ConfigDict,
    Field,
    ValidationError,
    model_validator,
)

from chenhorng.claims.courses import STATES
from chenhorng.configuration.model import (
    Allowed,
    Closed,
    Density,
    Diameter,
    Load,
    Roughness,
    Viscosity,
    first_fault,
    one_of,
)
from chenhorng.sampling import CURVE_QUANTITIES, RANGE_KEYS

CurveQuantity = Annotated[str, one_of(*CURVE_QUANTITIES)]
Ends = Field(min_length=2, max_length=2)
STATE = f"({'|'.join(STATES)})"
State = Annotated[
    str,
    Allowed(
        lambda text: bool(re.fullmatch(f"{STATE}( (or )?{STATE})*", text)),
        f"{', '.join(STATES)}, and alternatives with or",
    ),
]
# one value for all curves, or a list with a value for each curve
Listed = BeforeValidator(lambda value: value if isinstance(value, list) else [value])
Curves = Field(min_length=1, max_length=100)


class Conditions(BaseModel):
    """The conditions of the curves; the load, or the level of a quantity that determines the load;
    and the bounds of the loads.
    """

    model_config = ConfigDict(extra="allow", strict=True, allow_inf_nan=False)
    __pydantic_extra__: dict[str, float]

    viscosity_cSt: Annotated[list[Viscosity], Listed, Curves] = [0.0]
    particle_diameter_nm: Annotated[list[Diameter], Listed, Curves] = [0.0]
    roughness_nm: Annotated[list[Roughness], Listed, Curves] = [1.0]
    particle_density_per_m2: Annotated[list[Density], Listed, Curves] = [0.0]
    load_max_N: Load | None = None

    @model_validator(mode="after")
    def _are_of_curves(self):
        others = self.__pydantic_extra__.keys()
        if unknown := sorted(others - {*CURVE_QUANTITIES, *RANGE_KEYS}):
            raise ValueError(
                f"{unknown[0]!r:.60} is no condition; allowed: "
                f"{', '.join(type(self).model_fields)}, "
                "a quantity, and a quantity with _min or _max"
            )
        if len(levels := sorted(others & {*CURVE_QUANTITIES})) > 1:
            raise ValueError(f"{' and '.join(levels)} have a level; allowed: one quantity")
        lists = [value for _, value in self if isinstance(value, list)]
        if len(lengths := {len(values) for values in lists} - {1}) > 1:
            raise ValueError(f"lists of {sorted(lengths)} values; allowed: lists of one length")
        return self


class Reference(Closed):
    """The conditions that differ on the reference curve."""

    viscosity_cSt: Viscosity | None = None
    particle_diameter_nm: Diameter | None = None
    roughness_nm: Roughness | None = None
    particle_density_per_m2: Density | None = None


class Tolerance(Closed):
    """The largest deviation that counts as agreement, of one kind, and the reason for its size."""

    absolute: float | None = None
    relative: float | None = None
    factor: float | None = None
    reason: str

    @model_validator(mode="after")
    def _is_of_one_kind(self):
        if len(self.kinds) != 1:
            raise ValueError("allowed: one of absolute, relative and factor")
        return self

    @property
    def kinds(self) -> dict[str, float]:
        """The size of the tolerance by its kind."""
        sizes = self.model_dump(exclude={"reason"})
        return {kind: size for kind, size in sizes.items() if size is not None}


def checked(mapping: type[BaseModel]) -> AfterValidator:
    """A validator of a ``mapping`` that leaves the value as it is written."""

    def check(value: Any) -> Any:
        try:
            mapping.model_validate(value)
        except ValidationError as error:
            raise ValueError(first_fault(error)) from None
        return value

    return AfterValidator(check)
