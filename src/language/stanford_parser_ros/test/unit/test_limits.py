"""Texts that the models must never see."""

from typing import List, Sequence

import pytest

from stanford_parser_ros.model import MOST_WORDS, Parser, UnparsableText
from utterance_passes.trees.tree import DependencyTree
from utterance_passes.trees.vocabulary import NamedWord


class Asked(Exception):
    """The models were asked."""


class Models:
    """Models that tell what they are asked."""

    def __init__(self) -> None:
        self.texts: List[str] = []

    def parse(self, text: str) -> DependencyTree:
        self.texts.append(text)
        raise Asked

    def with_named_words(self, tree: DependencyTree, named: Sequence[NamedWord]) -> DependencyTree:
        raise AssertionError("nothing was parsed")


_MANY = [f"x{number}" for number in range(180)]


@pytest.mark.parametrize("text", [" ".join(_MANY), ",".join(_MANY), "?" * 499 + "a", "please " * 124])
def test_text_with_too_many_words_is_refused_before_the_models_see_it(text: str) -> None:
    models = Models()
    with pytest.raises(UnparsableText, match=f"at most {MOST_WORDS}") as refused:
        Parser(models).parse(text)
    assert refused.value.refusal[0] == "TEXT_TOO_LONG"
    assert models.texts == []


def test_text_with_as_many_words_as_allowed_is_parsed() -> None:
    text = " ".join(["moose"] * MOST_WORDS)
    models = Models()
    with pytest.raises(Asked):
        Parser(models).parse(text)
    assert models.texts == [text]
