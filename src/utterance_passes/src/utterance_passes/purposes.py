"""Attaches what something is for to the thing or to the deed: "a book *to read*", "open it *to air the room*"."""

from semantic_types.parts_of_speech import VERB, parts_of_speech
from utterance_passes.clauses import prepositions_of
from utterance_passes.pass_needs import only_with, only_with_forms
from utterance_passes.persons import is_person_or_name
from utterance_passes.tree import DependencyTree, Word
from utterance_passes.tree_edits import TreeEdit
from utterance_passes.vocabulary import Vocabulary
from word_classes import word_class

_INDEFINITE = word_class("indefinite_articles")
_INDEFINITE_THINGS = word_class("indefinite_things")
_NOUNS_WITH_TO = word_class("nouns_with_infinitives")
#: "Take a step *to face the door*": no step faces anything.
_STEPS = frozenset(["step"])
_CERTAIN = word_class("demonstrative_determiners") | {"the"}


@only_with_forms(_INDEFINITE_THINGS)
def with_purposes_of_things(tree: DependencyTree, _: Vocabulary) -> DependencyTree:
    """Make a clause of what something is for: "something *to drink*" is brought to no place.

    Whoever gets it, and what follows, belongs to the verb: "offer something to eat *to all the women in the kitchen*".
    """
    edit = TreeEdit(tree)
    for use in tree.words:
        case = tree.word(use.index - 1) if use.index > 1 else use
        thing = tree.word(use.index - 2) if use.index > 2 else use
        if thing.form.lower() not in _INDEFINITE_THINGS:
            continue
        before = tree.word(thing.head) if thing.deprel == "conj" else thing
        if before.deprel == "acl" and tree.word(before.head).form.lower() in _INDEFINITE_THINGS:
            # "Something to eat and *something* to drink."
            edit.rehang(thing.index, before.head)
        is_of_thing = use.deprel == "acl" and use.head == thing.index
        is_of_verb = use.deprel == "xcomp" and use.head == thing.head and tree.is_infinitive(use.index)
        if thing.deprel == "obj" and (is_of_thing or is_of_verb):
            phrases = [child for child in tree.children(use.index) if child.index > use.index]
            given = [phrase.index for phrase in phrases if "to" in prepositions_of(tree, phrase.index)]
            if given and is_of_verb:
                edit.rehang(use.index, thing.index, "acl")
            for phrase in phrases:
                if given and phrase.index >= given[0] and phrase.deprel == "obl":
                    edit.rehang(phrase.index, thing.head)
            continue
        is_to = case.deprel in ("case", "mark") and case.head == use.index and case.form.lower() == "to"
        is_bare = use.upos in ("NOUN", "VERB") and len(tree.children(use.index)) == 1
        if (
            is_to
            and is_bare
            and thing.index in tree.subtree(use.head)
            and (use.deprel not in ("acl", "xcomp", "advcl") or case.deprel == "case")
            and use.form == use.lemma
            and VERB in parts_of_speech(use.lemma)
        ):
            edit.tag(use.index, "VERB", "VB", "VerbForm=Inf")
            edit.rehang(use.index, thing.index, "acl")
            edit.retag(case.index, "PART", "TO")
            edit.relabel(case.index, "mark")
    return edit.tree()


@only_with("acl", "advcl")
def with_purposes_of_deeds(tree: DependencyTree, _: Vocabulary) -> DependencyTree:
    """Attach a purpose with an object of its own to the verb if it stands behind a certain thing: "open *the window to
    air the room*"; and one without an object to any thing before it: "find *a chair to sit on*".
    """
    edit = TreeEdit(tree)
    for use in tree.words:
        if use.deprel not in ("acl", "advcl") or not tree.is_infinitive(use.index):
            continue
        above, has_object = tree.word(use.head), _has_object(tree, use)
        is_of_verb = above.lemma.lower() in _STEPS or _is_certain(tree, above)
        if use.deprel == "acl" and above.deprel == "obj" and has_object and is_of_verb:
            edit.rehang(use.index, above.head, "advcl")
        if use.deprel == "advcl" and not has_object:
            first = min(tree.subtree(use.index))
            for thing in tree.children(above.index):
                if thing.deprel == "obj" and _is_any(tree, thing) and max(tree.subtree(thing.index)) + 1 == first:
                    edit.rehang(use.index, thing.index, "acl")
    return edit.tree()


def _has_object(tree: DependencyTree, use: Word) -> bool:
    """Whether a verb has what it acts on, so that the thing before it is not that: not in "a book to read"."""
    children = tree.children(use.index)
    behind = next(iter(tree.words[use.index :]), use)
    # "To let *in* some air", which may look like a place.
    places = [child.index for child in children if child.deprel == "obl"]
    is_particle = behind.upos == "ADP" and behind.head in places
    return is_particle or any(child.deprel in ("obj", "ccomp", "xcomp") for child in children)


def _is_any(tree: DependencyTree, thing: Word) -> bool:
    articles = {child.form.lower() for child in tree.children(thing.index) if child.deprel == "det"}
    is_thing = thing.upos == "NOUN" and not is_person_or_name(thing)
    return is_thing and (thing.form.lower() in _INDEFINITE_THINGS or bool(articles & _INDEFINITE))


def _is_certain(tree: DependencyTree, thing: Word) -> bool:
    if thing.lemma.lower() in _NOUNS_WITH_TO:
        return False  # "Show me the way to open the door."
    return any(
        child.deprel == "nmod:poss" or (child.deprel == "det" and child.form.lower() in _CERTAIN)
        for child in tree.children(thing.index)
    )
