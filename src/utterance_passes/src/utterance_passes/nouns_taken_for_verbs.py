"""Corrects the tags of nouns and amounts that the tagger took for verbs: "a knife, *fork* and *spoon*"."""

from typing import Sequence, Tuple

from semantic_types import Fit, shipped_types
from semantic_types.parts_of_speech import NOUN, parts_of_speech
from spoken_quantities import find_unit
from utterance_passes.two_word_nouns import is_two_word_noun
from utterance_passes.utterance_pass import Retag
from utterance_passes.vocabulary import Vocabulary
from word_classes import word_class

_ARTICLES = word_class("articles")
_BEFORE_DETERMINERS = word_class("before_determiners")
_DEEDS_ALONE = word_class("deeds_alone")
#: Tags before the last item of a list at the end: "a cup, *plate* and fork", "bring *the knife* and fork".
_ITEMS = (("NOUN", "PUNCT", "NOUN"), ("VERB", "DET", "NOUN"))
#: Parts of speech before a noun of two words.
_BEFORE_NOUNS = frozenset(["DET", "ADJ", "PRON", "NUM", "NOUN"])
_OBJECTS = word_class("object_beginnings")
_JOINTS = frozenset(["and", "or"])
#: Types of what can be taken, and of what can be read.
_THINGS = ("Physical_entity", "Information")


def nouns_in_lists(forms: Sequence[str], tags: Sequence[str], vocabulary: Vocabulary) -> Tuple[Retag, ...]:
    """Tag an item of a list as a noun that the tagger took for a verb: "a knife, *fork* and *spoon*"."""
    found: Tuple[Retag, ...] = ()
    for position, (form, tag) in enumerate(zip(forms, tags), start=1):
        before = tags[position - 2] if position > 1 else ""
        is_item = before == "PUNCT" and forms[position - 2] == "," and position > 2 and tags[position - 3] == "NOUN"
        is_item &= position < len(forms) and (forms[position] == "," or forms[position].lower() in _JOINTS)
        is_last = before == "CCONJ" and bool(found) and found[-1].position == position - 2
        # "A cup, plate and *fork*", "the knife and *fork*".
        is_at_end = frozenset(tags[position:]) <= {"PUNCT"}
        is_last |= before == "CCONJ" and is_at_end and tuple(tags[max(0, position - 5) : position - 2]) in _ITEMS
        is_last |= before == "CCONJ" and _is_second_thing(form, tags, position)
        is_noun = tag == "VERB" and NOUN in parts_of_speech(form) and not vocabulary.verbs_beginning_with(form.lower())
        if is_noun and (is_item or is_last):
            found = (*found, Retag(position, "NOUN", "NN", "Number=Sing"))
    # "A cup, polish and store it": somebody polishes it.
    return found if found and not any(tag == "VERB" for tag in tags[found[-1].position :]) else ()


def _is_second_thing(form: str, tags: Sequence[str], position: int) -> bool:
    """Whether a word behind a thing and "and" names another one, and not what is done to it: "put the knife and *fork*
    on the table", but "take the cup and *polish* it"."""
    is_behind_thing = tags[position - 3 : position - 2] == ["NOUN"] and form.lower() not in _DEEDS_ALONE
    is_without_object = position == len(tags) or tags[position] in ("ADP", "PUNCT", "CCONJ")
    return is_behind_thing and is_without_object and shipped_types().of_noun([form]).fit(_THINGS) is Fit.LIKELY


def amounts_as_verbs(forms: Sequence[str], tags: Sequence[str], vocabulary: Vocabulary) -> Tuple[Retag, ...]:
    """Tag the words of an amount that the tagger took for verbs: "then *half* a meter back", "and one *step* back"."""
    found = []
    for position, (form, tag) in enumerate(zip(forms, tags), start=1):
        if tag != "VERB" or vocabulary.verbs_beginning_with(form.lower()):
            continue
        unit = forms[position + 1] if position + 1 < len(forms) and forms[position].lower() in _ARTICLES else ""
        if form.lower() in _BEFORE_DETERMINERS and find_unit(unit):
            found.append(Retag(position, "DET", "PDT"))
        elif find_unit(form) and position > 1 and tags[position - 2] == "NUM":
            found.append(Retag(position, "NOUN", "NN", "Number=Sing"))
    return tuple(found)


def nouns_like_deeds(forms: Sequence[str], tags: Sequence[str], _: Vocabulary) -> Tuple[Retag, ...]:
    """Tag the second word of a noun of two words as a noun that the tagger took for a verb: "the night *stand*"."""
    said = [form.lower() for form in forms]
    return tuple(
        Retag(position, "NOUN", "NN", "Number=Sing")
        for position in range(3, len(said) + 1)
        if tags[position - 1] == "VERB" and tags[position - 2] == "NOUN" and tags[position - 3] in _BEFORE_NOUNS
        if "".join(said[position : position + 1]) not in _OBJECTS
        if is_two_word_noun(said[position - 2], said[position - 1])
    )
