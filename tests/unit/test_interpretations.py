"""Interpretations of the paper: objects that are found by the configuration's words, and nowhere else."""

from dataclasses import replace

import numpy as np
import pytest
from numpy.testing import assert_allclose

from thirdbody.configuration.plain_yaml import read_yaml
from thirdbody.configuration.schema import config_directory
from thirdbody.model.interpretations import INTERPRETATIONS


@pytest.mark.parametrize("name", INTERPRETATIONS)
def test_the_configuration_allows_the_words_that_are_known(name):
    entry = read_yaml(config_directory() / "inputs.yaml")[name]
    assert entry["allowed"] == list(INTERPRETATIONS[name])


@pytest.mark.parametrize("name", INTERPRETATIONS)
@pytest.mark.parametrize("word", ["solid", None, ["fluid"], 0.5])
def test_an_unknown_word_is_refused_by_name(parameters, name, word):
    allowed = ", ".join(map(str, INTERPRETATIONS[name]))
    with pytest.raises(ValueError) as refusal:
        replace(parameters, **{name: word})
    assert str(refusal.value) == f"{name} is {word!r}; allowed: {allowed}"


def test_the_sizes_that_are_drawn_are_those_that_are_solved(sizes):
    alone, diameter = replace(sizes, gap_ratio=0.0), np.array([500e-9])
    distribution = alone.interpretation.size_distribution
    law = distribution.law(diameter, 300e-9, alone)
    mean, spread = distribution.sizes(diameter, alone)
    assert_allclose(law.mean, mean, rtol=1e-15)
    assert_allclose(law.spread, spread, rtol=1e-15)
