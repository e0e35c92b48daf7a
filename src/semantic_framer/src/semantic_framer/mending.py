"""What a command cannot mean though the parser has it so: "go up" before "to", "can" without a verb."""

from dataclasses import replace
from typing import List

from spoken_quantities import find_unit, number_words
from stanford_parser_ros.tree import DependencyTree, Word

_TO = frozenset(["to", "into", "onto", "towards", "toward"])
#: What may stand between a verb of motion and "to": "go *up* to the desk".
_ON_THE_WAY = frozenset("up down over back out along across on off in".split())
_OF_PLACE = frozenset("in at on near above over under behind beside by inside outside next".split())
_ALL = frozenset("everything everyone everybody something someone somebody anything all".split())
_FRACTIONS = frozenset(["quarter", "half", "third", "full", "whole", "complete"])
_SEVERAL_TURNS = frozenset(["turns", "circles"])
_TURNS = frozenset(["turn", "circle"]) | _SEVERAL_TURNS
_TURNING = frozenset("turn rotate spin pivot swivel swing".split())
_SIDES = frozenset(["left", "right"])
#: Verbs that say nothing of their own: who makes a turn turns.
_LIGHT = frozenset(["make", "take", "do"])
#: What may stand in front of a noun, and its relation to the noun.
_OF_A_TURN = {"DET": "det", "NUM": "nummod", "NOUN": "compound", "ADJ": "amod", "ADV": "amod", "SYM": "punct"}
#: "A bit", "a little": how much of what the verb says.
DEGREES = frozenset(["bit", "little", "tad"])


def mended(tree: DependencyTree) -> DependencyTree:
    """Rehang words that hang where no command has them; the words stay the same."""
    for rule in _RULES:
        tree = rule(tree)
    return tree


def _with_particles_on_the_way(tree: DependencyTree) -> DependencyTree:
    """Make an adverb of a particle right in front of "to": in "go up to the desk" nothing is gone up."""
    words = [
        (
            replace(word, deprel="advmod")
            if word.deprel == "compound:prt"
            and word.form.lower() in _ON_THE_WAY
            and word.index < len(tree.words)
            and tree.word(word.index + 1).form.lower() in _TO
            and tree.word(word.index + 1).deprel == "case"
            else word
        )
        for word in tree.words
    ]
    return replace(tree, words=tuple(words)) if tuple(words) != tree.words else tree


def _with_places_of_devices(tree: DependencyTree) -> DependencyTree:
    """Hang a place behind "on" or "off" on the object in front: "turn *the lights* off *in the bedroom*"."""
    for particle in tree.words:
        if particle.deprel != "compound:prt" or particle.form.lower() not in ("on", "off"):
            continue
        objects = [c for c in tree.children(particle.head) if c.deprel == "obj" and c.index < particle.index]
        places = [
            c for c in tree.children(particle.head) if c.deprel == "obl" and _first(tree, c) == particle.index + 1
        ]
        if objects and places and tree.word(particle.index + 1).form.lower() in _OF_PLACE:
            words = list(tree.words)
            words[places[0].index - 1] = replace(places[0], head=objects[0].index, deprel="nmod")
            tree = replace(tree, words=tuple(words))
    return tree


def _with_degrees(tree: DependencyTree) -> DependencyTree:
    """Hang "a bit" and "a little" on the verb, and not on the noun that they stand behind."""
    for word in tree.words[2:]:
        before = tree.word(word.index - 1)
        modifiers = {child.form.lower() for child in tree.children(word.index)}
        if word.form.lower() not in DEGREES or not {"a"} <= modifiers <= {"a", "little", "tiny"}:
            continue
        governor = tree.word(word.head) if word.head else word
        is_behind = word.head and governor.index < before.index and governor.upos in ("NOUN", "PROPN", "PRON", "ADV")
        if is_behind and governor.head and tree.word(governor.head).upos == "VERB":
            words = list(tree.words)
            words[word.index - 1] = replace(word, head=governor.head, deprel="obl:unmarked")
            tree = replace(tree, words=tuple(words))
    return tree


def _first(tree: DependencyTree, word: Word) -> int:
    return tree.subtree(word.index)[0].index


def _with_modals_as_nouns(tree: DependencyTree) -> DependencyTree:
    """Make a noun of a modal that helps no verb and stands behind a noun: it is the head of a compound with that noun.

    "If you can" has a subject, "will you" too.
    """
    for modal in tree.words:
        before = tree.words[modal.index - 2] if modal.index > 1 else modal
        if modal.xpos != "MD" or before.upos not in ("NOUN", "PROPN"):
            continue
        below = [child for child in tree.children(modal.index) if child.upos != "PUNCT"]
        helps_nothing = not modal.deprel.startswith("aux") and modal.head in (before.index, before.head) and not below
        # An auxiliary stands before its verb; its verb before it has an object there, taken for a subject perhaps.
        is_behind_its_verb = (
            modal.deprel.startswith("aux") and 0 < modal.head < before.index and below in ([], [before])
        )
        if helps_nothing or is_behind_its_verb:
            head, deprel = (modal.head, "obj") if before.head == modal.index else (before.head, before.deprel)
            noun = replace(modal, upos="NOUN", xpos="NN", head=head, deprel=deprel)
            words = [replace(word, head=modal.index) if word.head == before.index else word for word in tree.words]
            words[modal.index - 1] = noun
            words[before.index - 1] = replace(before, head=modal.index, deprel="compound")
            tree = replace(tree, words=tuple(words))
    return tree


def _with_places_of_all(tree: DependencyTree) -> DependencyTree:
    """Hang a place on "everything" and the like in front of it: it tells which things, as behind a noun."""
    for pronoun in tree.words:
        if pronoun.form.lower() not in _ALL or pronoun.deprel != "obj":
            continue
        places = [c for c in tree.children(pronoun.head) if c.deprel == "obl" and _first(tree, c) == pronoun.index + 1]
        if places and tree.word(pronoun.index + 1).form.lower() in _OF_PLACE:
            words = list(tree.words)
            words[places[0].index - 1] = replace(places[0], head=pronoun.index, deprel="nmod")
            tree = replace(tree, words=tuple(words))
    return tree


def _with_measured_turns(tree: DependencyTree) -> DependencyTree:
    """Make a noun of "turn" behind a number or a fraction, which the parser takes for another command: "turn a quarter
    turn left", "make a 30 degree turn".
    """
    for turn in tree.words[2:]:
        phrase = _phrase_before(tree, turn)
        if turn.form.lower() not in _TURNS or turn.upos != "VERB" or not turn.head or not phrase:
            continue
        if not any(word.form.lower() in _FRACTIONS or word.upos == "NUM" for word in phrase):
            continue
        before = tree.words[phrase[0].index - 2] if phrase[0].index > 1 else turn
        is_made = before.upos == "VERB" and before.lemma.lower() in _LIGHT
        is_ratio = len(phrase) > 2 and phrase[-2].form == "/"
        is_said = phrase[-1].form.lower() in _FRACTIONS or turn.form.lower() in _SEVERAL_TURNS or is_ratio
        verb = before if is_made else tree.word(turn.head)
        if verb.upos != "VERB" or verb.index >= turn.index or not (is_made or is_said):
            continue
        words = [replace(word, head=verb.index) if word.head == turn.index else word for word in tree.words]
        relation = "obj" if is_made else "obl:unmarked"
        words[turn.index - 1] = replace(turn, upos="NOUN", xpos="NN", head=verb.index, deprel=relation)
        inside = {word.index for word in phrase}
        for word in phrase:
            if word.head not in inside:
                words[word.index - 1] = replace(word, head=turn.index, deprel=_OF_A_TURN.get(word.upos, word.deprel))
        tree = replace(tree, words=tuple(words))
    return tree


def _with_sides_apart(tree: DependencyTree) -> DependencyTree:
    """Hang a side in front of a measure on the verb: the parser has "to the right fifteen degrees" as one phrase."""
    for unit in tree.words:
        numbers = [child.index for child in (*tree.children(unit.index), unit) if _is_numeral(child)]
        if not numbers or not unit.head or not _is_of_a_measure(unit):
            continue
        before = [child for child in tree.children(unit.index) if child.index < min(numbers)]
        side = next((child for child in before if child.form.lower() in _SIDES), None)
        if side is None:
            continue
        words = list(tree.words)
        own = [child for child in before if child.index < side.index and child.deprel in ("case", "det", "nmod:poss")]
        is_phrase = any(child.deprel == "case" for child in own)
        upos, deprel = ("NOUN", "obl") if is_phrase else ("ADV", "advmod")
        words[side.index - 1] = replace(side, upos=upos, head=unit.head, deprel=deprel)
        for child in own:
            words[child.index - 1] = replace(child, head=side.index)
        if unit.deprel == "obl":
            words[unit.index - 1] = replace(unit, deprel="obl:unmarked")
        tree = replace(tree, words=tuple(words))
    return tree


def _is_of_a_measure(word: Word) -> bool:
    """Whether a word may be the head of a measure: a unit, a number, "quarters", "point"."""
    if word.upos in ("VERB", "AUX"):
        return False
    return find_unit(word.form) is not None or word.upos == "NUM" or word.form.lower() in (*number_words(), "point")


def _is_numeral(word: Word) -> bool:
    return word.deprel == "nummod" or word.form.lower() in number_words()


def _with_around_apart(tree: DependencyTree) -> DependencyTree:
    """Make an adverb of "around" between a verb of turning and a measure: who turns around 90 degrees goes round nothing."""
    for around in tree.words[1:]:
        verb = tree.word(around.index - 1)
        unit = tree.word(around.head) if around.head else around
        is_case = around.form.lower() == "around" and around.deprel in ("case", "advmod", "compound:prt")
        if is_case and verb.lemma.lower() in _TURNING and unit.index > around.index and _is_of_a_measure(unit):
            words = list(tree.words)
            words[around.index - 1] = replace(around, upos="ADV", head=verb.index, deprel="advmod")
            tree = replace(tree, words=tuple(words))
    return tree


def _phrase_before(tree: DependencyTree, noun: Word) -> List[Word]:
    """Return the words of a noun phrase in front of its noun; none where there are none."""
    phrase: List[Word] = []
    for word in reversed(tree.words[: noun.index - 1]):
        is_measure = word.form.lower() in _FRACTIONS or find_unit(word.form) is not None
        is_of_a_turn = word.upos in _OF_A_TURN and (word.upos not in ("NOUN", "ADV") or is_measure)
        if not is_of_a_turn and word.form != "-" and word.form.lower() not in _SIDES:
            break
        phrase.insert(0, word)
        if word.upos == "DET":
            break
    return phrase


_RULES = (
    _with_modals_as_nouns,
    _with_particles_on_the_way,
    _with_places_of_devices,
    _with_places_of_all,
    _with_measured_turns,
    _with_sides_apart,
    _with_around_apart,
    _with_degrees,
)
