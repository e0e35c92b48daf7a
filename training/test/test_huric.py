"""HuRIC's files are read, and their trees compared with ours."""

import pytest

from command_models import huric
from command_models.conllu import Sentence, Word
from command_models.errors import TrainingError

FILE = """<?xml version="1.0" encoding="UTF-8"?>
<huricExample id="1"><commands><command>
<sentence>put it near me</sentence>
<tokens>
<token id="1" lemma="put" pos="VB" surface="put"/><token id="2" lemma="it" pos="PRP" surface="it"/>
<token id="3" lemma="near" pos="IN" surface="near"/><token id="4" lemma="me" pos="PRP" surface="me"/>
</tokens>
<dependencies>
<dep from="0" to="1" type="root"/><dep from="1" to="2" type="dojb"/>
<dep from="1" to="3" type="prep"/><dep from="3" to="4" type="pobj"/>
</dependencies>
<semantics><frames><frame name="Placing"><lexicalUnit><token id="1"/></lexicalUnit></frame></frames></semantics>
</command></commands></huricExample>
"""


@pytest.fixture
def commands(tmp_path):
    (tmp_path / "1.hrc").write_text(FILE, encoding="utf-8")
    return huric.read_folder(tmp_path)


def tree(*rows):
    return Sentence(tuple(Word(form, form, "X", "X", "_", head, relation) for form, head, relation in rows))


RIGHT = tree(("put", 0, "root"), ("it", 1, "obj"), ("near", 4, "case"), ("me", 1, "obl"))


def test_gold_arguments(commands):
    assert commands[0].units == {1}
    assert commands[0].predicate() == 1
    assert huric.gold_arguments(commands[0]) == {(1, 2, "dobj"), (1, 4, "prep_near")}


def test_right_tree(commands):
    found = huric.score(commands, [RIGHT])
    assert (found.commands, found.predicates, found.arguments, found.attached) == (1, 1, 2, 2)
    assert not found.failures


def test_wrong_tree(commands):
    wrong = tree(("put", 2, "nsubj"), ("it", 0, "root"), ("near", 4, "case"), ("me", 2, "nmod"))
    found = huric.score(commands, [wrong])
    assert (found.predicates, found.attached) == (0, 0)
    assert len(found.failures) == 3


def test_place_as_predicate_is_headed_by_the_copula():
    given = tree(("cup", 4, "nsubj"), ("is", 4, "cop"), ("on", 4, "case"), ("table", 0, "root"))
    assert huric.our_root(given) == 2
    assert "prep_on" in huric.our_arguments(given)[(2, 4)]
    assert "nsubj" in huric.our_arguments(given)[(2, 1)]


def test_bare_measure_stands_for_object_and_adverb():
    given = tree(("move", 0, "root"), ("metres", 1, "obl:unmarked"))
    assert {"dobj", "npadvmod"} <= huric.our_arguments(given)[(1, 2)]


def test_no_files(tmp_path):
    with pytest.raises(TrainingError):
        huric.read_folder(tmp_path)


def test_broken_file_is_named(tmp_path):
    (tmp_path / "2.hrc").write_text("<commands>", encoding="utf-8")
    with pytest.raises(TrainingError) as error:
        huric.read_folder(tmp_path)
    assert "2.hrc" in str(error.value)
