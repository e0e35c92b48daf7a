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
#: Words of a gesture at most: "raising their left arm".
_LONGEST_GESTURE = 7
_ENDS_OF_GESTURES = frozenset(["VERB", "AUX", "CCONJ", "PUNCT"])
_PARTICIPLES = frozenset(["VBG", "VBN"])


def with_participles_at_nouns(tree: DependencyTree, _: Vocabulary) -> DependencyTree:
    """Attach a participle that directly follows a noun to this noun.

    What a person does or wears tells who is meant, and so do the posture of a thing and what was done with it ("the
    box standing on the table", "the cups left on the sofa"). Other participles with "-ing" say how to act: "clean the
    table using a cloth".
    """
    edit = TreeEdit(tree)
    for word in tree.words:
        person = _person_of_compound(tree, word)
        if person is not None:
            edit.rehang(person.index, word.head, word.deprel)
            edit.retag(word.index, "VERB", "VBG")
            edit.rehang(word.index, person.index, "acl")
            for child in tree.children(word.index):
                if child.index < person.index:
                    edit.rehang(child.index, person.index)
            continue
        behind = _person_behind(tree, word)
        if behind is not None:
            _hang_behind(tree, edit, word, behind)
            continue
        if _is_tagged_as_adjective(tree, word):
            edit.retag(word.index, "VERB", "VBN")
            edit.rehang(word.index, word.index - 1, "acl")
            for place in tree.words[word.index :]:
                if place.head < word.index and min(tree.subtree(place.index)) == word.index + 1:
                    edit.rehang(place.index, word.index, "obl")
            continue
        noun = _described(tree, word) if word.xpos in _PARTICIPLES and word.upos in ("VERB", "ADJ") else None
        if noun is not None:
            edit.rehang(word.index, noun.index, "acl")
    return edit.tree()


def _is_tagged_as_adjective(tree: DependencyTree, word: Word) -> bool:
    """Whether a word is a participle behind a person, and the parser takes it for an adjective: "the man *dressed* in a
    red coat"."""
    if word.upos != "ADJ" or not 1 < word.index < len(tree.words):
        return False
    noun = tree.word(word.index - 1)
    is_behind = word.deprel in ("amod", "advmod", "xcomp") and word.head in (noun.index, noun.head)
    is_participle = word.form.lower().endswith("ed") or word.xpos in _PARTICIPLES
    return is_behind and is_participle and is_person(noun) and tree.word(word.index + 1).upos == "ADP"


def _person_of_compound(tree: DependencyTree, word: Word) -> Optional[Word]:
    """Return the person of whom the parser makes a compound with a deed: "the *person* waving in the hall"."""
    before = tree.word(word.index - 1) if word.index > 1 else word
    is_compound = before.deprel == "compound" and before.head == word.index and word.upos in ("NOUN", "PROPN")
    has_determiner = any(child.deprel == "det" and child.index < before.index for child in tree.children(word.index))
    is_deed = word.form.lower().endswith("ing") and word.xpos in ("NN", "NNP", "VBG")
    return before if is_compound and is_deed and has_determiner and is_person(before) else None


def _person_behind(tree: DependencyTree, gerund: Word) -> Optional[Word]:
    """Return the person behind what the person does: "the pointing to the left *person*"."""
    is_gerund = gerund.upos == "VERB" and gerund.xpos == "VBG" and gerund.index > 1
    if not is_gerund or tree.word(gerund.index - 1).deprel != "det" or tree.word(gerund.index - 1).head != gerund.index:
        return None
    for word in tree.words[gerund.index : gerund.index + _LONGEST_GESTURE]:
        if word.upos in _ENDS_OF_GESTURES:
            return None
        if is_person(word) and tree.word(word.index - 1).upos not in ("DET", "PRON", "ADP"):
            return word
    return None


def _hang_behind(tree: DependencyTree, edit: TreeEdit, gerund: Word, person: Word) -> None:
    """Make the person the head of the phrase, and what stands between them a part of the gesture."""
    is_of_command = 0 < person.head < gerund.index and tree.word(person.head).upos == "VERB"
    top = person if is_of_command else gerund
    governor = tree.word(top.head) if top.head else top
    # "Bring water to the waving to you person": the person gets the water.
    is_of_object = governor.deprel == "obj" and top.deprel in ("nmod", "acl") and governor.head
    edit.rehang(person.index, governor.head if is_of_object else top.head, "obl" if is_of_object else top.deprel)
    for child in tree.children(gerund.index):
        if child.index < gerund.index and child.deprel == "mark":
            edit.make_preposition(child.index, person.index)
        elif child.index < gerund.index:
            edit.rehang(child.index, person.index)
    between = tree.words[gerund.index : person.index - 1]
    if between:
        last = between[-1]
        has_case = any(word.upos == "ADP" for word in between)
        edit.rehang(last.index, gerund.index, "obl" if has_case else "obj")
        for word in between[:-1]:
            if word.head in (person.index, gerund.index, 0) or word.head < gerund.index:
                edit.rehang(word.index, last.index)
    edit.rehang(gerund.index, person.index, "acl")


def _described(tree: DependencyTree, participle: Word) -> Optional[Word]:
    if participle.index < 3:
        return None
    noun = tree.word(participle.index - 1)
    # "Say the time to the man *waving* at the door": not the time is waving.
    is_of_another = participle.deprel == "acl" and participle.xpos == "VBG" and participle.head < noun.index
    if participle.deprel.split(":")[0] not in _OF_THE_VERB and not (is_of_another and is_person(noun)):
        return None
    # "And dancing", "by dancing" and "dancing" after a comma describe nothing.
    if min(tree.subtree(participle.index)) != participle.index:
        return None
    is_noun = noun.upos in ("NOUN", "PROPN") or noun.form.lower() in _INDEFINITE_PERSONS
    if not is_noun or noun.index == participle.head or noun.deprel == "compound":
        return None
    is_described = participle.xpos == "VBN" or participle.lemma.lower() in _POSTURES or is_person(noun)
    return noun if is_described else None
