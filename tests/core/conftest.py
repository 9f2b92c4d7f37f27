"""The methods of solving, and the style of figures."""

import matplotlib.style
import pytest
from methods import METHODS, solved_by

from thirdbody.plotting.drawing import STYLE


@pytest.fixture(params=METHODS)
def method(request):
    """Each method of solving, by which a test solves its points."""
    with solved_by(request.param):
        yield request.param


@pytest.fixture
def style():
    """The style of the figures."""
    with matplotlib.style.context(STYLE, after_reset=True):
        yield
