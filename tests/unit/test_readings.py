"""Readings of the paper: objects that are found by the configuration's words, and nowhere else."""

import ast
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from numpy.testing import assert_allclose

import benchmarks
import thirdbody as tb
from thirdbody.configuration.plain_yaml import read_yaml
from thirdbody.configuration.schema import config_directory
from thirdbody.figures.sections import size_quantiles
from thirdbody.model.interpretations import KINDS, Centred, FilmLoad, SizeDistribution

SOURCES = Path(tb.__file__).parent, Path(benchmarks.__file__).parent
LOADS = np.geomspace(1e-7, 1e-4, 5)


@pytest.mark.parametrize("name", KINDS)
def test_the_configuration_allows_the_words_that_are_known(name):
    entry = read_yaml(config_directory() / "inputs.yaml")[name]
    assert entry["allowed"] == list(KINDS[name].known)


@pytest.mark.parametrize("name", KINDS)
@pytest.mark.parametrize("word", ["solid", None, ["fluid"], 0.5])
def test_an_unknown_word_is_refused_by_name(parameters, name, word):
    allowed = ", ".join(map(str, KINDS[name].known))
    with pytest.raises(ValueError) as refusal:
        replace(parameters, **{name: word})
    assert str(refusal.value) == f"{name} is {word!r}; allowed: {allowed}"


def test_each_field_has_the_object_of_its_word(reading):
    for name, kind in KINDS.items():
        chosen = getattr(reading.interpretation, name)
        assert isinstance(chosen, kind)
        assert chosen is kind.known[getattr(reading, name)]


def test_no_other_module_compares_the_words():
    """An object's behaviour in an ``if`` on its word would be missed by a new reading."""
    words = {word for kind in KINDS.values() for word in kind.known if isinstance(word, str)}
    found = [
        (path.name, node.lineno)
        for folder in SOURCES
        for path in folder.rglob("*.py")
        if path.name != "baselines.py"  # equations of its own, independent of the library's
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8")))
        if isinstance(node, ast.Compare)
        for side in ast.walk(node)
        if isinstance(side, ast.Constant) and side.value in words
    ]
    assert not found


@pytest.fixture
def narrowed():
    """The word of a fourth size distribution, which is one class."""

    class Narrowed(Centred, word="narrowed"):
        """The centred one, half as wide."""

        def law(self, diameter, roughness, parameters):
            halved = replace(parameters, spread_ratio=0.5 * parameters.spread_ratio)
            return super().law(diameter, roughness, halved)

    yield "narrowed"
    del SizeDistribution.known["narrowed"]


def test_a_new_size_distribution_is_one_class(parameters, narrowed, method):
    sizes = {"mean_ratio": 0.5, "size_distribution": "centred"}
    like = replace(parameters, **sizes, spread_ratio=0.4)
    new = replace(parameters, **sizes | {"size_distribution": narrowed}, spread_ratio=0.8)
    expected, found = (
        tb.solve(
            load=LOADS,
            viscosity=90e-6,
            particle_diameter=500e-9,
            roughness=300e-9,
            particle_density=1e11,
            parameters=inputs,
        )
        for inputs in (like, new)
    )
    for name in vars(expected).keys() - {"conditions"}:
        assert np.array_equal(getattr(found, name), getattr(expected, name)), name


def test_quantiles_go_from_the_smallest_size_to_the_largest(sizes):
    distribution, diameter = sizes.interpretation.size_distribution, 500e-9
    mean, spread = distribution.sizes(diameter, sizes)
    largest = mean + sizes.truncation * spread
    shares = np.linspace(0.0, 1.0, 11)
    drawn = size_quantiles(shares, 300e-9, diameter, sizes)
    assert (np.diff(drawn) > 0.0).all()
    assert_allclose(drawn[[0, -1]], [300e-9, largest], rtol=1e-12)


def test_the_sizes_that_are_drawn_are_those_that_are_solved(sizes):
    alone, diameter = replace(sizes, gap_ratio=0.0), np.array([500e-9])
    distribution = alone.interpretation.size_distribution
    law = distribution.law(diameter, 300e-9, alone)
    mean, spread = distribution.sizes(diameter, alone)
    assert_allclose(law.mean, mean, rtol=1e-15)
    assert_allclose(law.spread, spread, rtol=1e-15)


def test_the_load_in_the_film_is_that_of_the_fluid_or_all():
    fluid, total = FilmLoad.known["fluid"], FilmLoad.known["total"]
    assert fluid.log_fraction(-3.0) == -3.0
    assert total.log_fraction(-3.0) == 0.0
    assert fluid.total_load(2.0, 3.0) == 5.0
    assert total.total_load(2.0, 3.0) == 3.0
    assert fluid.depends_on_shares
    assert not total.depends_on_shares
