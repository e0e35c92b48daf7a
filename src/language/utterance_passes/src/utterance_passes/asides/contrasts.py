"""Sets aside what is not wanted beside what is: "tea instead of coffee", "not the cup but the plate"."""

from typing import FrozenSet, List, Optional

from utterance_passes.engine.pass_needs import only_with_forms
from utterance_passes.engine.utterance_pass import Example, Kind, tree_pass
from utterance_passes.phrases.clauses import has_case
from utterance_passes.trees.tree import ASIDE, NOMINALS, VERBS, DependencyTree, Word
from utterance_passes.trees.tree_edits import TreeEdit
from utterance_passes.trees.vocabulary import Vocabulary
from word_classes import word_class

_ALL = word_class("words_for_all")
_CONTRASTS = word_class("contrasts")
_EXCEPTIONS = word_class("exceptions_of_all")
_NOT = word_class("not")
#: Relations that the parser gives to what is left out.
_LEFT_OUT = frozenset(["conj", "nmod", "obl", "obj"])
#: Relations of phrases that are added to a deed.
_OF_PHRASES = frozenset(["obl", "nmod", "conj", "appos", "obj", "parataxis"])
_STANDINS = word_class("noun_standins")
_OPPOSITE_SIDES = word_class("opposite_sides")
_NOT_ONLY = ["not", "only"]


@tree_pass(
    Kind.MEANING,
    Example(
        "bring|VERB|0|root anything|PRON|1|obj but|CCONJ|4|cc beer|NOUN|2|conj",
        ("but: cc(beer) CCONJ/but -> case(beer) ADP/but", "beer: conj(anything) -> nmod(anything)"),
    ),
    assigns=["case", "nmod"],
)
@only_with_forms(_EXCEPTIONS | _NOT)
def exceptions(tree: DependencyTree, _: Vocabulary) -> DependencyTree:
    """Take out of things what is not meant: "anything but beer", "a beer, not a warm one"."""
    return _with_kinds_left_out(_with_things_left_out(tree))


def _with_things_left_out(tree: DependencyTree) -> DependencyTree:
    """Take out of all things what stands behind "but"; it may stand behind other phrases: "put *everything* in the box
    *except the cup*"."""
    edit = TreeEdit(tree)
    for but in tree.words:
        if but.said not in _EXCEPTIONS or but.deprel not in ("case", "cc") or not but.head:
            continue
        left_out = tree.governor(but)
        is_thing = left_out.upos in NOMINALS or left_out.upos == "NUM"
        if not is_thing or left_out.deprel not in _LEFT_OUT or but.index > left_out.index:
            continue
        every = next((word for word in _things_before(tree, but, left_out) if _is_of_all(tree, word)), None)
        if every is not None:
            edit.retag(but.index, "ADP", "IN")
            edit.relabel(but.index, "case")
            edit.rehang(left_out.index, every.index, "nmod")
    return edit.tree()


def _things_before(tree: DependencyTree, but: Word, left_out: Word) -> List[Word]:
    """Return the things of which others may be left out: the one above, then the others of the deed, the last first."""
    above = tree.governor(left_out)
    deed = tree.subtree(tree.verb_above(above).index)
    before = [tree.word(index) for index in sorted(deed, reverse=True) if index < but.index]
    return [word for word in (above, *before) if word.upos in NOMINALS or word.upos == "DET"]


def _is_of_all(tree: DependencyTree, word: Word) -> bool:
    return any(one.said in _ALL for one in (word, *tree.children(word.index)))


def _with_kinds_left_out(tree: DependencyTree) -> DependencyTree:
    """Leave out what is like a thing but described: "a beer, *not a warm one*", "a cup, *but not the red one*".

    A thing with an adjective of its own is contrasted with another one: "the red mug, not the white one".
    """
    edit = TreeEdit(tree)
    for left_out in tree.words:
        denying = _denying_of_kind(tree, left_out)
        things = _things_like(tree, left_out) if denying else []
        if len(things) != 1 or _is_property_said(tree, things):
            continue
        for word in tree.children(left_out.index):
            if word in denying or word.said in _EXCEPTIONS:
                edit.retag(word.index, "ADP", "IN")
                edit.relabel(word.index, "case")
        edit.rehang(left_out.index, things[0].index, "nmod")
    return edit.tree()


def _denying_of_kind(tree: DependencyTree, word: Word) -> List[Word]:
    """Return the "not" that begins a described phrase without its noun: "*not* the red one"; none for others."""
    if word.said not in _STANDINS or word.deprel not in _OF_PHRASES or not word.head:
        return []
    own = tree.children(word.index)
    joints = {one.index for one in own if one.deprel in ("punct", "cc", "case")}
    first = min(tree.subtree(word.index) - joints)
    is_described = any(one.deprel.split(":")[0] in ("amod", "nmod", "acl") for one in own)
    return [one for one in own if one.said in _NOT and one.index == first] if is_described else []


def _things_like(tree: DependencyTree, left_out: Word) -> List[Word]:
    """Return the things that a phrase without its noun may be one of: the one above, and those of the deed."""
    above = tree.governor(left_out)
    of_deed = [one for one in tree.children(tree.verb_above(above).index) if one.deprel in ("obj", "obl")]
    things = [one for one in of_deed if one.upos == "NOUN" and one.index < left_out.index]
    return things if above.upos != "NOUN" or above in things else [*things, above]


def _is_property_said(tree: DependencyTree, things: List[Word]) -> bool:
    return any(child.deprel == "amod" for thing in things for child in tree.children(thing.index))


@tree_pass(
    Kind.MEANING,
    Example(
        "take|VERB|0|root not|PART|3|advmod cups|NOUN|1|obj but|CCONJ|5|cc plates|NOUN|3|conj",
        (
            "not: advmod(cups) -> discourse:aside(plates)",
            "cups: obj(take) -> discourse:aside(plates)",
            "but: cc(plates) -> discourse:aside(plates)",
            "plates: conj(cups) -> obj(take)",
        ),
    ),
    assigns=[ASIDE],
)
@only_with_forms(["but"])
def meant_instead(tree: DependencyTree, _: Vocabulary) -> DependencyTree:
    """Put what stands behind "but" in the place of what is denied before it: "bring *not the cup but* the plate",
    "*don't* go *to the hall but* to the office"."""
    edit = TreeEdit(tree)
    for but in tree.words:
        meant = tree.governor(but)
        denied = _denied(tree, meant) if but.said == "but" and but.index < meant.index else None
        denying = _denying(tree, denied) if denied is not None else frozenset()
        if denied is None or not denying:
            continue
        edit.rehang(meant.index, denied.head, denied.deprel)
        for index in (tree.subtree(denied.index) - tree.subtree(meant.index)) | denying | {but.index}:
            is_case = tree.word(index).deprel == "case" and tree.word(index).head == denied.index
            if is_case and not has_case(tree, meant):
                edit.rehang(index, meant.index)
            else:
                edit.rehang(index, meant.index, ASIDE)
    return edit.tree()


def _denied(tree: DependencyTree, meant: Word) -> Optional[Word]:
    """Return the phrase that "but" contrasts with another one; None for "anything but", and between deeds."""
    head = tree.governor(meant)
    before = [one for one in tree.children(head.index) if one.index < meant.index]
    # Behind a verb, the parser takes the second phrase for one like the first, or for one that is joined to the verb.
    alike = [one for one in before if one.deprel == meant.deprel != "conj" or _is_joined_alike(tree, one, meant)]
    phrases = [head] if meant.deprel == "conj" and head.upos != "VERB" else alike
    if not phrases or "VERB" in (meant.upos, phrases[-1].upos) or _is_of_all(tree, phrases[-1]):
        return None
    return phrases[-1]


def _is_joined_alike(tree: DependencyTree, phrase: Word, meant: Word) -> bool:
    prepositions = tree.said_prepositions(phrase.index)
    return meant.deprel == "conj" and bool(prepositions) and prepositions == tree.said_prepositions(meant.index)


def _denying(tree: DependencyTree, phrase: Word) -> FrozenSet[int]:
    """Return the words that deny a phrase: "not" right before it, or "do not" at its verb; none if nothing does."""
    first = tree.phrase_start(phrase.index)
    verb = tree.verb_above(tree.governor(phrase))
    nots = [
        word for word in tree.words[: phrase.index] if word.said in _NOT and word.head in (phrase.index, verb.index)
    ]
    if len(nots) != 1:
        return frozenset()
    helping = [one.index for one in tree.children(verb.index) if one.deprel == "aux" and one.lemma.lower() == "do"]
    if helping and nots[0].index == max(helping) + 1:
        return frozenset([*helping, nots[0].index])
    return frozenset([nots[0].index] if first - 1 <= nots[0].index else [])


@tree_pass(
    Kind.MEANING,
    Example(
        "bring|VERB|0|root tea|NOUN|1|obj instead|ADV|5|case of|ADP|5|case coffee|NOUN|1|obl",
        (
            "instead: case(coffee) -> discourse:aside(bring)",
            "of: case(coffee) -> discourse:aside(bring)",
            "coffee: obl(bring) -> discourse:aside(bring)",
        ),
    ),
    assigns=[ASIDE],
)
@only_with_forms(_NOT.union(*(phrase.split() for phrase in _CONTRASTS)))
def contrasts(tree: DependencyTree, _: Vocabulary) -> DependencyTree:
    """Set aside what is not wanted: "bring me tea *instead of coffee*", "go to the hall, *not the office*"."""
    edit = TreeEdit(tree)
    for word in tree.words:
        is_side = word.deprel in ("advmod", "conj") and word.said in _OPPOSITE_SIDES
        is_phrase = word.deprel in _OF_PHRASES and word.upos in NOMINALS
        if not (is_side or is_phrase) or _is_left_out(tree, word) or not _is_contrast(tree, word):
            continue
        for index in tree.subtree(word.index):
            edit.rehang(index, word.head, ASIDE)
    return edit.tree()


def _is_left_out(tree: DependencyTree, word: Word) -> bool:
    """Whether a phrase leaves out one of a kind, "a cup, *not the red one*"; of which thing may be open."""
    is_exception = any(one.said in _NOT for one in tree.prepositions(word.index))
    return is_exception or (
        bool(_denying_of_kind(tree, word)) and not _is_property_said(tree, _things_like(tree, word))
    )


def _is_contrast(tree: DependencyTree, word: Word) -> bool:
    said = [tree.word(index) for index in sorted(tree.subtree(word.index))]
    forms = [one.said for one in said if one.upos != "PUNCT"]
    if any(one.upos in VERBS for one in said):
        return False
    if any(" ".join(forms[:length]) in _CONTRASTS for length in (2, 3)):
        return True
    # Beside the verb, as an adverb, stands nothing but a side: "turn left and not *right*".
    is_joined = word.deprel in ("conj", "advmod")
    if forms[0] in ("and", "but") and forms[1:2] and forms[1] in _NOT and is_joined:
        thing = _wanted_instead(tree, word, said[0])
        # "All rooms but not the hall" leaves out one of them; "not through the hall" is about the way.
        is_of_all = _is_of_all(tree, thing) or any(child.said in _ALL for child in tree.children(thing.index))
        is_alike = tree.said_prepositions(word.index) == tree.said_prepositions(thing.index)
        return is_alike and not is_of_all and _is_last(tree, word)
    # Without the pause, "not" may belong to what is before it.
    is_set_off = said[0].form == "," and len(forms) > 1 and forms[0] in _NOT
    return is_set_off and word.index == tree.phrase_end(word.index) and _is_last(tree, word)


def _wanted_instead(tree: DependencyTree, word: Word, first: Word) -> Word:
    """Return what is contrasted with a phrase: its head, or, if that is the verb, the phrase of the verb before it: "go
    *to the hall* and not to the office"."""
    head = tree.governor(word)
    if head.upos != "VERB":
        return head
    before = [child for child in tree.children(head.index) if child.deprel == "obl" and child.index < first.index]
    return before[-1] if before else head


def _is_last(tree: DependencyTree, word: Word) -> bool:
    """Whether nothing, or a pause, follows: "take the red mug, *not the white one*, to my desk"."""
    if word.index < len(tree.words) and tree.word(word.index + 1).form == ",":
        return True
    return all(one.upos == "PUNCT" or one.deprel.startswith("discourse") for one in tree.words[word.index :])


@tree_pass(
    Kind.MEANING,
    Example(
        "take|VERB|0|root not|PART|1|advmod only|ADV|4|advmod cups|NOUN|1|obj but|CCONJ|6|cc plates|NOUN|4|conj",
        ("not: advmod(take) -> discourse:aside(take)", "only: advmod(cups) -> discourse:aside(take)"),
    ),
    requires=["cc"],
    assigns=[ASIDE],
)
def not_only(tree: DependencyTree, _: Vocabulary) -> DependencyTree:
    """Set "not only" aside before "but": "bring *not only* the cup but also the plate" forbids nothing."""
    edit = TreeEdit(tree)
    for first, second in zip(tree.words, tree.words[1:]):
        joints = [word for word in tree.words[second.index :] if word.said == "but" and word.deprel == "cc"]
        if [first.said, second.said] == _NOT_ONLY and joints and first.head:
            for word in (first, second):
                edit.rehang(word.index, first.head, ASIDE)
    return edit.tree()
