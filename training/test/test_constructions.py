"""The constructions: every tree is valid, those for scoring are taught by no other name, and draws repeat."""

import random
from dataclasses import replace
from pathlib import Path

import pytest

from command_models.conllu import Sentence, Word
from command_models.constructions import corpus, inflection, units, validity
from command_models.constructions.phrases import Phrases
from command_models.errors import TrainingError
from command_models.lexicon import EVALUATION, TRAINING, evaluation_words
from command_models.mining import Mined

DOMAINS = next(Path(__file__).resolve().parents[2].glob("src/**/roboframenet_domains/domains"))
UNITS = units.read_units(DOMAINS)


@pytest.mark.parametrize("scored", [False, True])
@pytest.mark.parametrize("lexicon", [TRAINING, EVALUATION])
def test_every_construction_draws_valid_trees(scored, lexicon):
    chooser = random.Random(11)
    phrases = Phrases(chooser, lexicon, Mined(), 0.1, UNITS)
    for one in corpus.constructions(scored=scored):
        for _ in range(25):
            sentence, text = corpus.draw(phrases, one, chooser, frozenset())  # raises where a tree is invalid
            assert text == sentence.text() and "  " not in text, one.name


def test_a_third_of_the_constructions_is_for_scoring():
    taught = {one.name for one in corpus.constructions(scored=False)}
    scored = {one.name for one in corpus.constructions(scored=True)}
    assert not taught & scored
    assert len(scored) >= 35


def test_taught_sentences_have_no_evaluation_words_and_repeat():
    made = corpus.taught(300, 4, Mined(), UNITS)
    assert made == corpus.taught(300, 4, Mined(), UNITS)
    banned = evaluation_words()
    assert not any(word.lemma.lower() in banned for sentence in made for word in sentence.words)
    assert {sentence.comment("construction") for sentence in made} <= {
        one.name for one in corpus.constructions(scored=False)
    }


def test_a_stranded_preposition_hangs_on_the_question_word():
    chooser = random.Random(2)
    phrases = Phrases(chooser, TRAINING, Mined(), 0.0, UNITS)
    (one,) = [one for one in corpus.constructions(scored=False) if one.name == "stranded"]
    for _ in range(20):
        sentence, _ = corpus.draw(phrases, one, chooser, frozenset())
        case = [word for word in sentence.words if word.deprel == "case"][-1]
        governor = sentence.words[case.head - 1]
        assert governor.deprel == "obl"
        assert sentence.words.index(governor) < sentence.words.index(case)


def tree(*rows):
    return Sentence(tuple(Word(form, form, upos, "X", "_", head, deprel) for form, upos, head, deprel in rows))


GOOD = tree(("close", "VERB", 0, "root"), ("the", "DET", 3, "det"), ("door", "NOUN", 1, "obj"))


@pytest.mark.parametrize(
    ("place", "change", "reason"),
    [
        (1, {"deprel": "case"}, "case is DET"),
        (1, {"head": 2}, "circle"),
        (2, {"head": 0, "deprel": "root"}, "one root"),
        (2, {"head": 2}, "circle"),
        (2, {"deprel": "aux"}, "aux is NOUN"),
        (1, {"upos": "PUNCT"}, "punctuation"),
    ],
)
def test_what_is_invalid_is_named(place, change, reason):
    assert validity.violations(GOOD) == []
    words = list(GOOD.words)
    words[place] = replace(words[place], **change)
    assert any(reason in problem for problem in validity.violations(Sentence(tuple(words))))


def test_crossing_arcs_are_named():
    crossing = tree(
        ("a", "NOUN", 3, "nsubj"), ("b", "NOUN", 4, "obj"), ("c", "VERB", 0, "root"), ("d", "VERB", 3, "conj")
    )
    assert any("cross" in problem for problem in validity.violations(crossing))
    assert validity.violations(crossing, projective=False) == []


@pytest.mark.parametrize(
    ("lemma", "past", "participle", "ing"),
    [
        ("bring", "brought", "brought", "bringing"),
        ("drive", "drove", "driven", "driving"),
        ("grip", "gripped", "gripped", "gripping"),
        ("close", "closed", "closed", "closing"),
        ("carry", "carried", "carried", "carrying"),
    ],
)
def test_forms_of_verbs(lemma, past, participle, ing):
    assert inflection.past_form(lemma) == past
    assert inflection.participle_form(lemma) == participle
    assert inflection.ing_form(lemma) == ing


def test_a_folder_without_units_is_an_error(tmp_path):
    with pytest.raises(TrainingError, match="no lexical_units"):
        units.read_units(tmp_path)
