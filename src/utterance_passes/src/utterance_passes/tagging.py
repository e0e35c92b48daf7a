"""Corrects tags by the lexicon: the tagger learned from text in which commands are rare."""

import re
from typing import List, Optional, Sequence, Tuple

from semantic_types import Fit, shipped_types
from semantic_types.parts_of_speech import ADJECTIVE, ADVERB, NOUN, VERB, parts_of_speech
from spoken_quantities import number_words
from utterance_passes.amounts import SIGNS
from utterance_passes.tree import DependencyTree
from utterance_passes.tree_edits import TreeEdit
from utterance_passes.utterance_pass import Retag
from utterance_passes.vocabulary import Vocabulary
from word_classes import word_class

_ARTICLES = word_class("articles")
_BEFORE_GERUNDS = word_class("aspectual_verbs") | word_class("verbs_before_gerunds")
_CONDITIONS = word_class("conditions")
_DETERMINERS = word_class("determiners_and_possessives")
_DO = word_class("forms_of_do")
_AUXILIARIES = word_class("forms_of_have") | _DO
_FORMS_OF_BE = word_class("forms_of_be")
_NEVER_OWNERS = word_class("pronouns_before_is")
#: Tags behind the name of a person at the end of a phrase, and right behind the verb.
_BEHIND_NAMES = frozenset(["PUNCT", "CCONJ", "ADP", "ADV", "INTJ"])
_BEHIND_PERSONS = frozenset(["DET", "PRON", "ADP"])
_NUMBER_WORDS = frozenset(number_words())
_OBJECTS = word_class("object_beginnings")
_PARTICLES = word_class("verb_particles")
#: Tags of the last two words of an object or a place before "and".
_PHRASE_ENDS = (
    ("DET", "NOUN"),
    ("PRON", "NOUN"),
    ("DET", "ADJ"),
    ("ADP", "PROPN"),
    ("ADP", "NUM"),
    ("VERB", "PROPN"),
    ("NOUN", "NOUN"),
)
#: The type of what can be counted, brought or wanted beside another thing.
_TOUCHED = ("Physical_entity", "Information")
_PERSONS = word_class("personal_subjects")
#: "The man and guide *that* I met" has a relative clause.
_POINTED_AT = (word_class("pronouns_of_things") | word_class("pronouns_of_persons_or_things")) - {"that"}
_PREPOSITIONS = word_class("prepositions_taken_for_adverbs")
#: Endings of words that compare; behind a noun they are adjectives: "the door furthest to the left".
_CHANGED = word_class("changed_states")
_COMPARING = tuple(word_class("comparing_endings"))
_INDEFINITE = word_class("indefinite_things")
_LEADING = word_class("leading_verbs")
_LEAD_IN = word_class("lead_in")
_PLACE_PREPOSITIONS = word_class("place_prepositions")
_RESULTS = word_class("resulting_states")
#: A name of one letter.
_LETTER = re.compile("[A-Z][0-9]*")
_NO = word_class("objections")
_NOUNS = {"NOUN", "PROPN", "PRON", "NUM", "ADJ", "DET"}
_SIDES = word_class("left_and_right")
_WAYS = word_class("ways_to_go")
_THEN = word_class("adverbs_of_order")
_VERB_ENDINGS = ("ing", "ed")
#: Relations of words that belong to the verb of the command, not to the word that the parser took for it.
_OF_THE_VERB = frozenset(["punct", "obl", "advmod", "discourse", "vocative", "conj", "parataxis"])


def command_verb(forms: Sequence[str], tags: Sequence[str], vocabulary: Vocabulary) -> Tuple[Retag, ...]:
    """Tag the first word of a command as a verb if the lexicon knows it as one: "Scrub the pot", "Ping"."""
    position = command_verb_position(forms, vocabulary)
    if position is None or tags[position - 1] == "VERB":
        return ()
    return (_imperative(position),)


def _imperative(position: int) -> Retag:
    return Retag(position, "VERB", "VB", "Mood=Imp|Person=2|VerbForm=Fin")


def verbs_behind_commas(forms: Sequence[str], tags: Sequence[str], vocabulary: Vocabulary) -> Tuple[Retag, ...]:
    """Tag a verb of the lexicon behind a comma as a verb that the tagger took for a noun: "find Anna, *spot* Bob"."""
    said, tags = [form.lower() for form in [*forms, ""]], [*tags, "PUNCT"]
    if command_verb_position(forms, vocabulary) is None and said[0] not in _CONDITIONS:
        return ()
    return tuple(
        _imperative(position)
        for position, (form, tag) in enumerate(zip(forms, tags), start=1)
        if tag in ("NOUN", "ADJ") and position > 2 and forms[position - 2] == ","
        if form.islower() and vocabulary.verbs_beginning_with(form)
        # "The guide, Bob" has no verb, and neither has "room, table and chair". No adjective stands before an article.
        if (tag == "NOUN" and tags[position] == "PROPN" and forms[position - 3].lower() not in _ARTICLES)
        or (tag == "ADJ" and tags[position] in ("DET", "NUM"))
        or _is_to_somebody(said, tags, position)
        or _is_event_at_end(form, tags, position)
        # "If it rings, *report* back to Anna."
        or (tag == "NOUN" and said[position] in _PARTICLES and tags[position] != "VERB" and said[0] in _CONDITIONS)
    )


def verbs_behind_no(forms: Sequence[str], tags: Sequence[str], vocabulary: Vocabulary) -> Tuple[Retag, ...]:
    """Tag a verb of the lexicon behind "no" that the tagger took for a noun: "turn left no *turn* right"."""
    return tuple(
        _imperative(position)
        for position, (form, tag) in enumerate(zip(forms, tags), start=1)
        if tag == "NOUN" and 2 < position < len(forms) and tags[position - 2] in ("INTJ", "DET")
        if forms[position - 2].lower() in _NO and vocabulary.verbs_beginning_with(form.lower())
        if tags[position] in ("ADV", "ADP", "DET", "PRON", "PROPN", "ADJ")
    )


def verbs_behind_and(forms: Sequence[str], tags: Sequence[str], vocabulary: Vocabulary) -> Tuple[Retag, ...]:
    """Tag a verb of the lexicon between "and" and "to me", or "and" and a pronoun, as a verb that the tagger took for a
    noun or an adjective: "count all and *report* to me", "look whether all are closed and *close* those that are not";
    and the last word behind a name: "find Anna, and *wave*"."""
    said, tags = [form.lower() for form in [*forms, ""]], [*tags, "PUNCT"]
    return tuple(
        _imperative(position)
        for position, (form, tag) in enumerate(zip(forms, tags), start=1)
        if tag in ("NOUN", "ADJ") and position > 2 and said[position - 2] == "and"
        if form.islower() and vocabulary.verbs_beginning_with(form)
        if _is_to_somebody(said, tags, position)
        or (said[position] in _POINTED_AT and tags[position] == "PRON")
        # "The kitchen and *high* five Bob": an adjective stands before no number.
        or (tag == "ADJ" and tags[position] == "NUM")
        or _is_last_deed(tags, position)
        or _is_event_at_end(form, tags, position)
    )


def _is_to_somebody(said: Sequence[str], tags: Sequence[str], position: int) -> bool:
    """Whether "to" and a pronoun are behind a noun: "*report* to me"."""
    return tags[position - 1] == "NOUN" and said[position] == "to" and "PRON" in tags[position + 1 : position + 2]


def _is_last_deed(tags: Sequence[str], position: int) -> bool:
    """Whether a word without an article behind a name or a place, a comma and "and" ends the utterance: "spot Alex, and
    *wave*" names no second person, "spot Alex in the hall, and *wave*" no second place."""
    before = tuple(tags[max(0, position - 6) : position - 1])
    is_behind = before[-3:] == ("PROPN", "PUNCT", "CCONJ") or before == ("ADP", "DET", "NOUN", "PUNCT", "CCONJ")
    return is_behind and all(tag == "PUNCT" for tag in tags[position:])


def _is_event_at_end(form: str, tags: Sequence[str], position: int) -> bool:
    """Whether a noun without an article at the end names a deed, and no thing or person: "count the people and
    *wave*"."""
    is_last = all(tag == "PUNCT" for tag in tags[position:])
    before = tags[max(0, position - 4) : position - 2]
    is_behind_phrase = tuple(before) in _PHRASE_ENDS
    return is_last and is_behind_phrase and shipped_types().of_noun([form]).fit(_TOUCHED) is not Fit.LIKELY


def no_one(forms: Sequence[str], tags: Sequence[str], _: Vocabulary) -> Tuple[Retag, ...]:
    """Tag "no one" behind a verb as a noun without anything: "tell *no one* the secret"."""
    return tuple(
        retag
        for position in range(2, len(forms))
        if forms[position - 1].lower() == "no" and forms[position].lower() == "one"
        if tags[position - 1] == "INTJ" and tags[position - 2] == "VERB"
        for retag in (Retag(position, "DET", "DT"), Retag(position + 1, "NOUN", "NN", "Number=Sing"))
    )


def sides_alone(forms: Sequence[str], tags: Sequence[str], vocabulary: Vocabulary) -> Tuple[Retag, ...]:
    """Tag a side at the front, or behind "then", as an adverb that the tagger took for a verb: "*left*, not right" has
    nobody who left, nor has "turn right, then *left* 45 degrees"; "turn *left* walk on" has no state."""
    found = []
    for position, (form, tag) in enumerate(zip(forms, tags), start=1):
        is_next = position > 1 and forms[position - 2].lower() in _THEN
        behind = tags[position] if position < len(forms) else "PUNCT"
        is_turned = (
            tag == "ADJ" and position > 1 and tags[position - 2] == "VERB" and behind in ("VERB", "CCONJ", "PUNCT")
        )
        # "Forward two metres" forwards nothing, nor does "turn left, *forward* two metres".
        is_item = is_next or (position > 1 and forms[position - 2] in (",", ";") and tags[0] == "VERB")
        is_front_verb = tag == "VERB" and (is_item or position == 1)
        is_gone = is_front_verb and behind == "NUM" and not vocabulary.verbs_beginning_with(form.lower())
        if (is_turned and form.lower() in _SIDES) or (is_gone and form.lower() in _WAYS):
            found.append(Retag(position, "ADV", "RB"))
        if is_front_verb and form.lower() in _SIDES:
            if behind == "PUNCT" or (is_item and behind == "NUM"):
                found.append(Retag(position, "ADV", "RB"))
    return tuple(found)


def numbers_as_nouns(forms: Sequence[str], tags: Sequence[str], _: Vocabulary) -> Tuple[Retag, ...]:
    """Tag a number behind an article and an adjective as a noun: "a low *five*", "the right *one*", but not
    "turn to the left *one* oh five degrees", where the number goes on."""
    return tuple(
        Retag(position, "NOUN", "NN", "Number=Sing")
        for position, (form, tag) in enumerate(zip(forms, tags), start=1)
        if tag == "NUM" and position > 2 and tags[position - 2] == "ADJ"
        if forms[position - 3].lower() in (_DETERMINERS if form.lower() == "one" else ("a",))
        if position == len(tags) or tags[position] in ("PUNCT", "INTJ", "CCONJ")
        if not frozenset(word.lower() for word in forms[position : position + 3]) & _NUMBER_WORDS
    )


def signs(forms: Sequence[str], tags: Sequence[str], _: Vocabulary) -> Tuple[Retag, ...]:
    """Tag signs before a number as adverbs: "turn right *minus minus* 4 turns" goes beyond no number."""
    found: Tuple[Retag, ...] = ()
    is_before_number = False
    for position in range(len(forms), 0, -1):
        is_sign = is_before_number and forms[position - 1].lower() in SIGNS
        if is_sign and tags[position - 1] != "ADV":
            found = (Retag(position, "ADV", "RB"), *found)
        is_before_number = is_sign or tags[position - 1] == "NUM"
    return found


def command_verb_position(forms: Sequence[str], vocabulary: Vocabulary) -> Optional[int]:
    """Find the word that must be the verb of a command: the first one after the addressee, politeness and fillers.

    Args:
        forms: words of the sentence
        vocabulary: known verbs
    Returns:
        its index from 1; None if the front of the sentence has no known verb
    """
    position = 0
    while position < len(forms) and (forms[position].lower() in _LEAD_IN or forms[position] == ","):
        position += 1
    if position < len(forms) and vocabulary.verbs_beginning_with(forms[position].lower()):
        # "Name is Bob": a noun before a finite verb is not a command.
        following = forms[position + 1].lower() if position + 1 < len(forms) else ""
        # "Have you been there" is a question.
        is_auxiliary = forms[position].lower() in _AUXILIARIES and following in _PERSONS
        return None if following in _FORMS_OF_BE or is_auxiliary else position + 1
    return None


def numbered_noun(forms: Sequence[str], tags: Sequence[str], vocabulary: Vocabulary) -> Tuple[Retag, ...]:
    """Tag a word between "to" and a final number or letter as a noun if the lexicon does not know it as a verb: "order
    seven" is a thing with a number, not a command.
    """
    position = numbered_noun_position(forms, tags, vocabulary)
    return () if position is None else (Retag(position - 1, "ADP", "IN"), Retag(position, "NOUN", "NN", "Number=Sing"))


def numbered_noun_position(forms: Sequence[str], tags: Sequence[str], vocabulary: Vocabulary) -> Optional[int]:
    """Find a noun that the tagger took for a verb because it stands between "to" and a number or a letter.

    Args:
        forms: words of the sentence
        tags: their universal parts of speech
        vocabulary: known verbs
    Returns:
        its index from 1; None if there is none
    """
    for position in range(2, len(forms) - 1):
        is_last = position + 2 == len(forms) or tags[position + 2] in ("PUNCT", "CCONJ")
        if (
            forms[position - 1].lower() == "to"
            and tags[position] == "VERB"
            and (tags[position + 1] == "NUM" or _LETTER.fullmatch(forms[position + 1]))
            and (
                not vocabulary.verbs_beginning_with(forms[position].lower())
                # "Go to point A" is no purpose; "I want you to press A" has another word before "to".
                or (tags[position - 2] == "VERB" and _LETTER.fullmatch(forms[position + 1]))
            )
            and is_last
        ):
            return position + 1
    return None


def adverbs(forms: Sequence[str], tags: Sequence[str], vocabulary: Vocabulary) -> Tuple[Retag, ...]:
    """Tag a word as an adverb that the tagger took for a noun or a verb, though English knows it as neither: "bring me
    the mug *angrily*"."""
    return tuple(
        Retag(position, "ADV", "RB")
        for position, (form, tag) in enumerate(zip(forms, tags), start=1)
        if tag in ("NOUN", "PROPN", "VERB") and form.islower() | (position == 1)
        if not vocabulary.verbs_beginning_with(form.lower()) and form.lower() not in _PREPOSITIONS
        if not form.lower().endswith(_COMPARING)
        for parts in [parts_of_speech(form)]
        if ADVERB in parts and not parts & {NOUN, VERB}
    )


def prepositions_as_verbs(forms: Sequence[str], tags: Sequence[str], _: Vocabulary) -> Tuple[Retag, ...]:
    """Tag a word before a noun as a preposition that the tagger took for a verb: "the room *opposite* the lift"."""
    return tuple(
        Retag(position, "ADP", "IN")
        for position, (form, tag) in enumerate(zip(forms, tags), start=1)
        if tag == "VERB" and position < len(forms) and tags[position] in _NOUNS
        if form.lower() in _PLACE_PREPOSITIONS and VERB not in parts_of_speech(form.lower())
    )


def prepositions_before_names(forms: Sequence[str], tags: Sequence[str], _: Vocabulary) -> Tuple[Retag, ...]:
    """Tag "to" before a name as a preposition that the tagger took for the mark of a verb: "say the time *to* Bob"."""
    return tuple(
        Retag(position, "ADP", "IN")
        for position in range(2, len(forms))
        if forms[position - 1].lower() == "to" and tags[position - 1] == "PART" and tags[position] == "PROPN"
    )


def left_behind(forms: Sequence[str], tags: Sequence[str], _: Vocabulary) -> Tuple[Retag, ...]:
    """Tag "left" between somebody and something as a verb that the tagger took for a side: "Bob *left* his keys"."""
    said = [form.lower() for form in forms]
    for position in range(2, len(forms)):
        if said[position - 1] != "left" or tags[position - 1] == "VERB":
            continue
        is_first_verb = not frozenset(["VERB", "AUX"]) & frozenset(tags[: position - 1])
        is_thing_behind = said[position] in _OBJECTS and tags[position + 1 : position + 2] in (["NOUN"], ["ADJ"])
        if is_first_verb and is_thing_behind and tags[position - 2] in ("PROPN", "PRON"):
            return (Retag(position, "VERB", "VBD", "Mood=Ind|Tense=Past|VerbForm=Fin", "leave"),)
    return ()


def gerunds_as_nouns(forms: Sequence[str], tags: Sequence[str], vocabulary: Vocabulary) -> Tuple[Retag, ...]:
    """Tag a gerund between a verb and a noun as a part of the noun, if the verb takes no gerund: "bring *cleaning*
    supplies". "Try opening doors" has two verbs."""
    return tuple(
        Retag(position, "NOUN", "NN", "Number=Sing")
        for position, (form, tag) in enumerate(zip(forms, tags), start=1)
        if tag == "VERB" and form.lower().endswith("ing") and 1 < position < len(forms)
        if tags[position - 2] == "VERB" and tags[position] == "NOUN"
        for verb in [forms[position - 2].lower()]
        if vocabulary.verbs_beginning_with(verb) and verb not in _BEFORE_GERUNDS
    )


def names_as_verbs(forms: Sequence[str], tags: Sequence[str], vocabulary: Vocabulary) -> Tuple[Retag, ...]:
    """Tag a word with a capital inside a sentence as a name if the lexicon knows no such verb: "give Tom a cup and
    *Lisa* a fork", "tell Anna and then *Bob*". Where every word has a capital, it must be no verb of English either."""
    are_capitals_rare = any(form.islower() for form in forms[1:])
    return tuple(
        Retag(position, "PROPN", "NNP", "Number=Sing")
        for position, (form, tag) in enumerate(zip(forms, tags), start=1)
        if tag == "VERB" and position > 1 and form.istitle() and forms[position - 2] not in (".", "!", "?", '"')
        if are_capitals_rare or VERB not in parts_of_speech(form.lower())
        if not vocabulary.verbs_beginning_with(form.lower())
    )


def small_names_as_verbs(forms: Sequence[str], tags: Sequence[str], vocabulary: Vocabulary) -> Tuple[Retag, ...]:
    """Tag a word in small letters that English does not know as a name, if it stands where a person is named: "bring
    the cup to *daniele*", "give *ravi* the keys". "I want you to *yeet* the ball" keeps a verb that nobody knows."""
    found: List[Retag] = []
    for position, (form, tag) in enumerate(zip(forms, tags), start=1):
        is_unknown = form.islower() and form.isalpha() and not parts_of_speech(form)
        is_known_verb = form.endswith(_VERB_ENDINGS) or bool(vocabulary.verbs_beginning_with(form))
        if position == 1 or tag != "VERB" or is_known_verb or not is_unknown:
            continue
        before, behind = forms[position - 2].lower(), next(iter(tags[position:]), "PUNCT")
        if before == "to" and position > 2 and behind in _BEHIND_NAMES:
            found += [Retag(position - 1, "ADP", "IN"), Retag(position, "PROPN", "NNP", "Number=Sing")]
        elif vocabulary.verbs_beginning_with(before) and before not in _LEADING and behind in _BEHIND_PERSONS:
            found.append(Retag(position, "PROPN", "NNP", "Number=Sing"))
    return tuple(found)


def nouns_behind_verbs(forms: Sequence[str], tags: Sequence[str], vocabulary: Vocabulary) -> Tuple[Retag, ...]:
    """Tag a word right behind the verb of the command as a noun that English does not know as a verb, "give
    *grandpa* his glasses"; what the tagger takes for an adverb must be a person."""
    verb = command_verb_position(forms, vocabulary)
    if verb is None or verb >= len(forms) or tags[verb] not in ("VERB", "ADV"):
        return ()
    form = forms[verb].lower()
    parts = parts_of_speech(form)
    if tags[verb] == "ADV" and (ADVERB in parts or shipped_types().of_noun([form]).fit(["Human"]) is not Fit.LIKELY):
        return ()
    is_noun = NOUN in parts and VERB not in parts and not form.endswith(_VERB_ENDINGS)
    return (
        (Retag(verb + 1, "NOUN", "NN", "Number=Sing"),) if is_noun and not vocabulary.verbs_beginning_with(form) else ()
    )


def contracted_verbs(forms: Sequence[str], tags: Sequence[str], _: Vocabulary) -> Tuple[Retag, ...]:
    """Tag "'s" as a verb where no noun follows that somebody could own: "tell them dinner*'s* in the hall"."""
    return tuple(
        Retag(position, "AUX", "VBZ", "Mood=Ind|Number=Sing|Person=3|Tense=Pres|VerbForm=Fin", "be")
        for position, (form, tag) in enumerate(zip(forms, tags), start=1)
        if form.lower() == "'s" and tag == "PART" and 1 < position < len(forms)
        if forms[position - 2].lower() in _NEVER_OWNERS
        or (tags[position - 2] == "NOUN" and tags[position] in ("ADP", "DET", "PRON"))
    )


def verbs_of_conditions(forms: Sequence[str], tags: Sequence[str], _: Vocabulary) -> Tuple[Retag, ...]:
    """Tag a verb behind the subject of a condition that the tagger took for a noun: "when Bob *leaves* the office",
    "tell me if Bob *leaves*", "say hello when the bell *rings*"."""
    return tuple(
        Retag(position, "VERB", "VBZ", "Mood=Ind|Number=Sing|Person=3|Tense=Pres|VerbForm=Fin", lemma)
        for position, (form, tag) in enumerate(zip(forms, tags), start=1)
        if tag == "NOUN" and form.endswith("s") and position > 2
        if position == len(forms) or tags[position] in ("DET", "PUNCT", "CCONJ")
        for subject in [2 if tags[position - 3 : position - 1] == ["DET", "NOUN"] else 1]
        if tags[position - 2] in ("PROPN", "PRON") or subject == 2
        if position > 1 + subject and forms[position - 2 - subject].lower() in _CONDITIONS
        for lemma in [next((base for base in (form[:-1], form[:-2]) if VERB in parts_of_speech(base)), "")]
        if lemma
    )


def verbs_of_questions(forms: Sequence[str], tags: Sequence[str], _: Vocabulary) -> Tuple[Retag, ...]:
    """Tag a word behind "do" and a noun as a verb that the tagger took for a noun, though English knows it only as a
    verb: "who does the mug *belong* to"."""
    return tuple(
        Retag(position, "VERB", "VB", "VerbForm=Inf", form)
        for position, (form, tag) in enumerate(zip(forms, tags), start=1)
        if tag == "NOUN" and position > 2 and tags[position - 2] in ("NOUN", "PROPN", "PRON")
        if any(before.lower() in _DO for before in forms[: position - 2])
        if parts_of_speech(form) == frozenset([VERB])
    )


def resulting_states(forms: Sequence[str], tags: Sequence[str], _: Vocabulary) -> Tuple[Retag, ...]:
    """Tag a state behind a noun as an adjective that the tagger took for a noun: "slide the drawer *shut*"."""
    return tuple(
        Retag(position, "ADJ", "JJ", "Degree=Pos")
        for position, (form, tag) in enumerate(zip(forms, tags), start=1)
        # "See the door open" has two verbs, "pull the door closed" has one.
        if tag == "NOUN" or (tag == "VERB" and form.lower().endswith("ed"))
        if form.lower() in _RESULTS | _CHANGED and position > 2 and tags[position - 2] == "NOUN"
        if position == len(forms)
        or tags[position] in ("PUNCT", "CCONJ", "INTJ")
        or (tags[position] == "ADV" and frozenset(tags[position + 1 :]) <= {"PUNCT"})
        or forms[position].lower() in _CONDITIONS
        or (form.lower() in _CHANGED and tags[position] == "ADP")
    )


def properties_of_pronouns(forms: Sequence[str], tags: Sequence[str], _: Vocabulary) -> Tuple[Retag, ...]:
    """Tag a property behind "anything" as an adjective that the tagger took for a noun: "get me anything *sweet*"."""
    return tuple(
        Retag(position, "ADJ", "JJ", "Degree=Pos")
        for position, (form, tag) in enumerate(zip(forms, tags), start=1)
        if tag == "NOUN" and position > 1 and forms[position - 2].lower() in _INDEFINITE
        if ADJECTIVE in parts_of_speech(form) and not (position < len(forms) and tags[position] == "NOUN")
    )


def rerooted(tree: DependencyTree, vocabulary: Vocabulary) -> DependencyTree:
    """Make the verb of the command the root, and attach the old root and the phrases of the command to it."""
    index = command_verb_position([word.form for word in tree.words], vocabulary)
    if index is None or tree.word(index).head == 0:
        return tree
    old_root = tree.children(0)[0]
    edit = TreeEdit(tree)
    for word in tree.children(old_root.index):
        if word.deprel.split(":")[0] in _OF_THE_VERB:
            edit.rehang(word.index, index)
    edit.rehang(old_root.index, index, "obj" if old_root.upos in _NOUNS else "xcomp")
    edit.rehang(index, 0, "root")
    edit.drop_brackets()
    return edit.tree()
