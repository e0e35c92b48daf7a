"""Attaches participles to the person or thing that they describe: "greet the woman *wearing a red coat*"."""

from typing import Optional

from utterance_passes.persons import is_person
from utterance_passes.tree import DependencyTree, Word
from utterance_passes.tree_edits import TreeEdit
from utterance_passes.vocabulary import Vocabulary
from word_classes import word_class

_INDEFINITE_PERSONS = word_class("indefinite_persons")
_POSTURES = word_class("posture_verbs")
#: Relations that the parser gives to a participle behind a noun if it takes it for a clause of the verb.
_OF_THE_VERB = frozenset(["advcl", "xcomp", "ccomp", "conj", "parataxis", "obl", "advmod", "dep"])
_PARTICIPLES = frozenset(["VBG", "VBN"])


def with_participles_at_nouns(tree: DependencyTree, _: Vocabulary) -> DependencyTree:
    """Attach a participle that directly follows a noun to this noun.

    What a person does or wears tells who is meant, and so do the posture of a thing and what was done with it ("the
    box standing on the table", "the cups left on the sofa"). Other participles with "-ing" say how to act: "clean the
    table using a cloth".
    """
    edit = TreeEdit(tree)
    for word in tree.words:
        noun = _described(tree, word) if word.xpos in _PARTICIPLES and word.upos in ("VERB", "ADJ") else None
        if noun is not None:
            edit.rehang(word.index, noun.index, "acl")
    return edit.tree()


def _described(tree: DependencyTree, participle: Word) -> Optional[Word]:
    if participle.deprel.split(":")[0] not in _OF_THE_VERB or participle.index < 3:
        return None
    # "And dancing", "by dancing" and "dancing" after a comma describe nothing.
    if min(tree.subtree(participle.index)) != participle.index:
        return None
    noun = tree.word(participle.index - 1)
    is_noun = noun.upos in ("NOUN", "PROPN") or noun.form.lower() in _INDEFINITE_PERSONS
    if not is_noun or noun.index == participle.head or noun.deprel == "compound":
        return None
    is_described = participle.xpos == "VBN" or participle.lemma.lower() in _POSTURES or is_person(noun)
    return noun if is_described else None
