"""Corrects parses that a command cannot mean: "go up" before "to", "can" without a verb."""

from typing import FrozenSet, Iterable, List, Sequence

from spoken_quantities import find_unit, number_words
from utterance_passes.amounts import read_amounts
from utterance_passes.clauses import has_case, is_then
from utterance_passes.pass_needs import only_with, only_with_forms
from utterance_passes.tree import DependencyTree, Word
from utterance_passes.tree_edits import TreeEdit
from utterance_passes.vocabulary import Vocabulary
from word_classes import word_class

_LIGHT_VERBS = word_class("light_verbs_of_deeds")
_ABOUT = frozenset(["about"])
_CHANGED_STATES = word_class("changed_states")
_DEGREES = word_class("degrees")
#: Relations of phrases that end with a noun.
_NOMINAL = frozenset(["obj", "iobj", "obl", "nmod"])
_DEGREE_ADJECTIVES = word_class("degree_adjectives")
_INDEFINITES = word_class("indefinites")
_PARTICLES_ON_THE_WAY = word_class("particles_on_the_way")
_PARTS_OF_A_TURN = word_class("parts_of_a_turn")
_PLACE_PREPOSITIONS = word_class("place_prepositions")
_HOW_OFTEN = word_class("iteration_adverbs")
_LEFT_AND_RIGHT = word_class("left_and_right")
_LIGHT = word_class("light_verbs")
_TURNING = word_class("turning_verbs")
_TURNS = frozenset(["turn", "circle"])
_SEVERAL_TURNS = frozenset(["turns", "circles"])
#: Parts of speech that can precede a noun, and their relations to the noun.
_OF_A_TURN = {"DET": "det", "NUM": "nummod", "NOUN": "compound", "ADJ": "amod", "ADV": "amod", "SYM": "punct"}
_PER = word_class("words_for_each")
#: Tags of a verb that only a finite one has.
_FINITE_TAGS = frozenset(["VBZ", "VBD"])
_TO_PREPOSITIONS = word_class("to_prepositions")


def with_modals_as_nouns(tree: DependencyTree, _: Vocabulary) -> DependencyTree:
    """Turn a modal after a noun into a noun if it helps no verb; it becomes the head of a compound with that noun.

    "If you can" and "will you" have a subject, and stay as they are.
    """
    for modal in tree.words:
        before = tree.words[modal.index - 2] if modal.index > 1 else modal
        if modal.xpos != "MD" or before.upos not in ("NOUN", "PROPN"):
            continue
        below = [child for child in tree.children(modal.index) if child.upos != "PUNCT"]
        helps_nothing = not modal.deprel.startswith("aux") and modal.head in (before.index, before.head) and not below
        # An auxiliary precedes its verb. If the verb precedes it, the noun between them is an object, which the parser
        # may have labelled as a subject.
        is_behind_its_verb = (
            modal.deprel.startswith("aux") and 0 < modal.head < before.index and below in ([], [before])
        )
        # "Bring the watering can to the hall": no hall has an auxiliary.
        helped = tree.word(modal.head) if modal.head else modal
        is_of_noun = helped.upos == "NOUN" and helped.index > modal.index and has_case(tree, helped) and not below
        if helps_nothing or is_behind_its_verb or is_of_noun or _is_before_finite(tree, modal):
            edit = TreeEdit(tree)
            edit.rehang_children(before.index, modal.index)
            head, deprel = (modal.head, "obj") if before.head == modal.index else (before.head, before.deprel)
            edit.retag(modal.index, "NOUN", "NN")
            edit.rehang(modal.index, head, deprel)
            edit.rehang(before.index, modal.index, "compound")
            tree = edit.tree()
    return tree


def _is_before_finite(tree: DependencyTree, modal: Word) -> bool:
    """Whether a finite verb follows, which no modal has: "if the trash *can is* full"."""
    following = tree.word(modal.index + 1) if modal.index < len(tree.words) else modal
    return following.xpos in _FINITE_TAGS and modal.deprel.startswith("aux")


@only_with("compound:prt")
def with_particles_on_the_way(tree: DependencyTree, _: Vocabulary) -> DependencyTree:
    """Turn a particle right before "to" into an adverb: "go up to the desk" does not mean "go up"."""
    edit = TreeEdit(tree)
    for word, following in zip(tree.words, tree.words[1:]):
        is_to = following.form.lower() in _TO_PREPOSITIONS and following.deprel == "case"
        if word.deprel == "compound:prt" and word.form.lower() in _PARTICLES_ON_THE_WAY and is_to:
            edit.relabel(word.index, "advmod")
    return edit.tree()


@only_with("compound:prt", "xcomp")
def with_places_of_devices(tree: DependencyTree, _: Vocabulary) -> DependencyTree:
    """Attach a place after "on", "off" or a changed state to the object before it: "turn *the lights* off *in the
    bedroom*"."""
    edit = TreeEdit(tree)
    for particle in tree.words:
        is_switch = particle.deprel == "compound:prt" and particle.form.lower() in ("on", "off")
        # "Make the lights brighter in the hall": the parser may attach the place to the state.
        is_state = particle.deprel == "xcomp" and particle.form.lower() in _CHANGED_STATES
        if not is_switch and not is_state:
            continue
        objects = [c for c in tree.children(particle.head) if c.deprel == "obj" and c.index < particle.index]
        below = tree.children(particle.index) if is_state else ()
        places = _phrases_at(tree, (*tree.children(particle.head), *below), particle.index + 1)
        for place in places[:1] if objects else ():
            edit.rehang(place.index, objects[0].index, "nmod")
    return edit.tree()


@only_with("obj")
def with_places_of_all(tree: DependencyTree, _: Vocabulary) -> DependencyTree:
    """Attach a place to "everything" or a similar word before it: the place says which things, as after a noun. So does
    "about": "tell something *about yourself*"."""
    edit = TreeEdit(tree)
    for pronoun in tree.words:
        if pronoun.form.lower() in _INDEFINITES and pronoun.deprel == "obj":
            words = tree.children(pronoun.head)
            for phrase in _phrases_at(tree, words, pronoun.index + 1, _PLACE_PREPOSITIONS | _ABOUT)[:1]:
                edit.rehang(phrase.index, pronoun.index, "nmod")
    return edit.tree()


def _phrases_at(
    tree: DependencyTree, words: Iterable[Word], position: int, prepositions: FrozenSet[str] = _PLACE_PREPOSITIONS
) -> List[Word]:
    """Return the words that head a phrase of a verb at a position, by default a phrase of place."""
    if position > len(tree.words) or tree.word(position).form.lower() not in prepositions:
        return []
    return [word for word in words if word.deprel == "obl" and min(tree.subtree(word.index)) == position]


@only_with("vocative", "discourse")
def with_objects_of_vocatives(tree: DependencyTree, _: Vocabulary) -> DependencyTree:
    """Turn a false vocative back into the end of the object, "push the blue robot", or the degree of the deed, "*half*
    open the door".

    A true vocative is set off or comes at an end, and the phrase before it is complete without it.
    """
    edit = TreeEdit(tree)
    first = tree.words[0]
    is_outside = first.deprel in ("vocative", "discourse") and first.head == first.index + 1
    if is_outside and first.form.lower() in _PARTS_OF_A_TURN:
        edit.retag(first.index, "ADV", "RB")
        edit.relabel(first.index, "advmod")
    for word in tree.words[2:]:
        before = tree.word(word.index - 1)
        determiners = [child for child in tree.children(word.index) if child.deprel in ("det", "nmod:poss")]
        if word.deprel != "vocative" or not word.head > 0:
            continue
        verb = tree.word(word.head)
        if word.index > verb.index and any(child.deprel == "case" for child in tree.children(word.index)):
            edit.relabel(word.index, "obl")  # "follow behind Bob"
        elif determiners and min(child.index for child in determiners) > verb.index and not _has_object(tree, verb):
            edit.rehang(word.index, verb.index, "obj")
        elif before.upos == "DET" and before.deprel == "obj" and before.head == word.head:
            edit.rehang(word.index, verb.index, "obj")  # "follow that robot"
            edit.rehang(before.index, word.index, "det")
        elif before.upos == "ADJ" and before.deprel in _NOMINAL and before.head and _has_determiner(tree, before):
            edit.rehang(word.index, before.head, before.deprel)
            edit.rehang(before.index, word.index, "amod")
            for child in tree.children(before.index):
                if child.index < before.index:
                    edit.rehang(child.index, word.index, child.deprel)
    return edit.tree()


def _has_object(tree: DependencyTree, verb: Word) -> bool:
    return any(child.deprel in ("obj", "ccomp", "xcomp") for child in tree.children(verb.index))


def _has_determiner(tree: DependencyTree, word: Word) -> bool:
    return any(child.deprel in ("det", "nmod:poss") for child in tree.children(word.index))


@only_with_forms(_PER)
def with_speeds_together(tree: DependencyTree, _: Vocabulary) -> DependencyTree:
    """Attach the time of a speed to its length: "two metres *a second*", "half a metre *per second*"."""
    edit = TreeEdit(tree)
    for length, per, time in zip(tree.words, tree.words[1:], tree.words[2:]):
        if per.form.lower() not in _PER:
            continue
        units = (find_unit(length.form), find_unit(time.form))
        is_speed = [unit.quantity for unit in units if unit is not None] == ["length", "duration"]
        is_counted = any(child.index < length.index for child in tree.children(length.index))
        if is_speed and is_counted and length.head not in (per.index, time.index):
            edit.rehang(time.index, length.index, "nmod")
            edit.rehang(per.index, time.index)
    return edit.tree()


@only_with_forms(_TURNS | _SEVERAL_TURNS)
def with_measured_turns(tree: DependencyTree, _: Vocabulary) -> DependencyTree:
    """Turn the verb "turn" after a number or a fraction into a noun: "turn a quarter turn left", "make a 30 degree
    turn". The parser takes it for another command.
    """
    tree = _without_turning_parts(tree)
    for turn in tree.words[2:]:
        phrase = _number_before(tree, turn) or _phrase_before(tree, turn) if _is_turn(turn) and turn.head else []
        if not any(word.form.lower() in _PARTS_OF_A_TURN or word.upos == "NUM" for word in phrase):
            continue
        before = tree.words[phrase[0].index - 2] if phrase[0].index > 1 else turn
        is_made = before.upos == "VERB" and before.lemma.lower() in _LIGHT
        is_ratio = len(phrase) > 2 and phrase[-2].form == "/"
        # No command ends with "turn": it would not say where to.
        is_last = all(word.upos == "PUNCT" for word in tree.words[turn.index :])
        is_share = phrase[-1].form.lower() in _PARTS_OF_A_TURN or is_ratio
        is_said = is_share or is_last or turn.form.lower() in _SEVERAL_TURNS or _is_one_turn(tree, phrase)
        verb = before if is_made else _verb_before(tree, phrase[0], turn)
        if verb.upos != "VERB" or verb.index >= turn.index or not (is_made or is_said):
            continue
        edit = TreeEdit(tree)
        edit.rehang_children(turn.index, verb.index)
        edit.retag(turn.index, "NOUN", "NN")
        edit.rehang(turn.index, verb.index, "obj" if is_made else "obl:unmarked")
        inside = {word.index for word in phrase}
        for word in phrase:
            if word.head not in inside:
                edit.rehang(word.index, turn.index, _OF_A_TURN.get(word.upos, word.deprel))
        tree = edit.tree()
    return tree


def _without_turning_parts(tree: DependencyTree) -> DependencyTree:
    """Make a measure of a part of a turn that the parser took for who turns: "*a quarter* turn to the right"."""
    edit = TreeEdit(tree)
    for part in tree.words[:-1]:
        is_subject = part.deprel.startswith("nsubj") and part.head == part.index + 1
        if is_subject and part.form.lower() in _PARTS_OF_A_TURN and _is_turn(tree.word(part.head)):
            edit.relabel(part.index, "obl:unmarked")
    return edit.tree()


def _is_one_turn(tree: DependencyTree, phrase: Sequence[Word]) -> bool:
    """Whether the words before "turn" are "one" behind a verb of turning: "rotate (almost) one turn clockwise"."""
    before = [word for word in tree.words[: phrase[0].index - 1] if word.upos not in ("ADV", "DET")]
    return phrase[-1].form.lower() == "one" and bool(before) and before[-1].lemma.lower() in _TURNING


def _verb_before(tree: DependencyTree, phrase: Word, turn: Word) -> Word:
    """Return the last verb before a phrase: "move back and turn a quarter turn" turns by it, and does not move."""
    verbs = [word for word in tree.words[: phrase.index - 1] if word.upos == "VERB"]
    outside = [word for word in verbs if word.index not in tree.subtree(turn.index)]
    return outside[-1] if outside else tree.word(turn.head)


def _asks_for_assent(tree: DependencyTree, side: Word) -> bool:
    """Whether "right" is no side: "turn left, *right*?"."""
    around = [word.form for word in tree.words[side.index - 2 : side.index + 1]]
    return around[:1] + around[2:] == [",", "?"] and side.form.lower() == "right" and side.deprel == "advmod"


@only_with_forms(_LEFT_AND_RIGHT)
def with_sides_apart(tree: DependencyTree, _: Vocabulary) -> DependencyTree:
    """Attach a side and the measure after it separately to the verb: the parser makes one phrase of "to the right
    fifteen degrees", and of "right twice", and an interjection of "then right".
    """
    for side in tree.words:
        governor = tree.word(side.head) if side.head else side
        if side.form.lower() not in _LEFT_AND_RIGHT:
            continue
        if side.deprel == "discourse" and any(child.form.lower() == "then" for child in tree.children(side.index)):
            # Nobody agrees with "then right".
            edit = TreeEdit(tree)
            edit.relabel(side.index, "advmod")
            tree = edit.tree()
            continue
        if _asks_for_assent(tree, side):
            edit = TreeEdit(tree)
            edit.relabel(side.index, "discourse")
            tree = edit.tree()
            continue
        if governor.deprel == "nummod":
            governor = tree.word(governor.head)
        if governor.form.lower() in _HOW_OFTEN and side.index == governor.index - 1 and governor.head:
            edit = TreeEdit(tree)
            edit.rehang(side.index, governor.head, "advmod")
            tree = edit.tree()
            continue
        below = [child for child in tree.children(side.index) if child.index > side.index and _is_joined(tree, child)]
        if below and governor.upos == "VERB":
            edit = TreeEdit(tree)
            for measure in below:
                edit.rehang(measure.index, governor.index, "obl:unmarked")
            tree = edit.tree()
        numbers = [child.index for child in (*tree.children(governor.index), governor) if _is_numeral(child)]
        if not numbers or side.index > min(numbers) or not governor.head or not _is_of_a_measure(governor):
            continue
        if _is_thing(tree, governor):
            continue
        edit = TreeEdit(tree)
        own = [
            child
            for child in tree.children(governor.index)
            if child.index < side.index
            if child.deprel in ("case", "det", "nmod:poss", "cc", "punct") or is_then(child)
        ]
        is_phrase = any(child.deprel == "case" for child in own)
        edit.retag(side.index, "NOUN" if is_phrase else "ADV")
        edit.rehang(side.index, governor.head, "obl" if is_phrase else "advmod")
        for child in own:
            edit.rehang(child.index, side.index)
        if governor.deprel == "obl":
            edit.relabel(governor.index, "obl:unmarked")
        tree = edit.tree()
    return tree


def _is_thing(tree: DependencyTree, word: Word) -> bool:
    """Whether "one" is a thing and no number: "next to *the right one*", "*your left one* and go home"."""
    behind = tree.words[word.index : word.index + 3]
    is_last = all(other.upos in ("PUNCT", "CCONJ") for other in behind[:1])
    is_last &= not any(other.form.lower() in number_words() for other in behind)
    is_one = word.form.lower() == "one" and any(
        child.deprel in ("det", "nmod:poss") for child in tree.children(word.index)
    )
    return is_one and is_last


def _is_joined(tree: DependencyTree, word: Word) -> bool:
    """Whether the parser attached a word of a measure to the word before it: "the left 5 and a half"."""
    has_case = any(child.deprel == "case" and child.index < word.index for child in tree.children(word.index))
    is_joined = word.deprel.split(":")[0] in ("conj", "nmod", "flat", "appos", "nummod", "dep")
    return is_joined and _is_of_a_measure(word) and not has_case


@only_with("case", "advmod", "compound:prt")
def with_around_apart(tree: DependencyTree, _: Vocabulary) -> DependencyTree:
    """Turn "around" between a verb of turning and a measure into an adverb: nothing goes round the measure."""
    for around in tree.words[1:]:
        verb = tree.word(around.index - 1)
        unit = tree.word(around.head) if around.head else around
        is_case = around.form.lower() == "around" and around.deprel in ("case", "advmod", "compound:prt")
        if is_case and verb.lemma.lower() in _TURNING and unit.index > around.index and _is_of_a_measure(unit):
            edit = TreeEdit(tree)
            edit.retag(around.index, "ADV")
            edit.rehang(around.index, verb.index, "advmod")
            tree = edit.tree()
    return tree


def _is_of_a_measure(word: Word) -> bool:
    """Whether a word can be the head of a measure: a unit, a number, "quarters", "point"."""
    if word.upos in ("VERB", "AUX"):
        return False
    return find_unit(word.form) is not None or word.upos == "NUM" or word.form.lower() in (*number_words(), "point")


def _is_numeral(word: Word) -> bool:
    return word.deprel == "nummod" or word.form.lower() in number_words()


def _is_turn(word: Word) -> bool:
    return word.form.lower() in _TURNS | _SEVERAL_TURNS and word.upos == "VERB"


def _number_before(tree: DependencyTree, unit: Word) -> List[Word]:
    """Return the words of the number before a unit, such as "two and two thirds"; empty if there is no number."""
    amounts = read_amounts(tree, [word.index for word in tree.words[: unit.index]]) if _is_turn(unit) else ()
    return [
        tree.word(index)
        for amount in amounts[-1:]
        if amount.unit_position == unit.index
        for index in amount.positions[:-1]
    ]


def _phrase_before(tree: DependencyTree, noun: Word) -> List[Word]:
    """Return the words of a noun phrase before its noun; empty if there are none."""
    phrase: List[Word] = []
    for word in reversed(tree.words[: noun.index - 1]):
        is_measure = word.form.lower() in _PARTS_OF_A_TURN or find_unit(word.form) is not None
        is_of_a_turn = word.upos in _OF_A_TURN and (word.upos not in ("NOUN", "ADV") or is_measure)
        if not is_of_a_turn and word.form != "-" and word.form.lower() not in _LEFT_AND_RIGHT:
            break
        phrase.insert(0, word)
        if word.upos == "DET":
            break
    return phrase


@only_with_forms(_DEGREES)
def with_degrees(tree: DependencyTree, _: Vocabulary) -> DependencyTree:
    """Attach "a bit" and "a little" to the verb, not to the noun before them."""
    edit = TreeEdit(tree)
    for word in tree.words[2:]:
        before = tree.word(word.index - 1)
        modifiers = {child.form.lower() for child in tree.children(word.index)}
        if word.form.lower() not in _DEGREES or not {"a"} <= modifiers <= {"a"} | _DEGREE_ADJECTIVES:
            continue
        governor = tree.word(word.head) if word.head else word
        is_behind = word.head and governor.index < before.index and governor.upos in ("NOUN", "PROPN", "PRON", "ADV")
        if is_behind and governor.head and tree.word(governor.head).upos == "VERB":
            edit.rehang(word.index, governor.head, "obl:unmarked")
    return edit.tree()


@only_with("obl:unmarked")
def with_steps_taken(tree: DependencyTree, _: Vocabulary) -> DependencyTree:
    """Make an amount right behind a verb that means little alone its object: "take *three steps* back"."""
    edit = TreeEdit(tree)
    for amount in tree.words:
        verb = tree.word(amount.head) if amount.head else amount
        if amount.deprel != "obl:unmarked" or verb.lemma.lower() not in _LIGHT_VERBS:
            continue
        has_object = any(child.deprel in ("obj", "iobj") for child in tree.children(verb.index))
        if not has_object and min(tree.subtree(amount.index)) == verb.index + 1:
            edit.relabel(amount.index, "obj")
    return edit.tree()
