"""Words of a person from the view of the robot."""

from functools import lru_cache
from typing import Dict

from word_classes.shipped import word_list

_MARKS = " .!?,"


def turned_round(words: str, *, is_clause: bool = False) -> str:
    """Return words of a person from the view of the robot: "bring you your mug" for "bring me my mug".

    Args:
        words: as they were said
        is_clause: whether they begin with their subject: "you see a wall" becomes "I see a wall"
    """
    turned_words, hearer = _turned_words(), word_list("words_of_the_hearer")[0]
    turned = []
    for place, word in enumerate(words.strip(_MARKS).split()):
        plain = word.lower()
        if is_clause and place == 0 and plain == hearer:
            turned.append("I")
        elif is_clause and place == 1 and turned[0] == "I" and plain == "are":
            turned.append("am")
        elif is_clause and place == 1 and turned[0] == hearer and plain == "am":
            turned.append("are")
        else:
            turned.append(turned_words.get(plain, word))
    return " ".join(turned)


@lru_cache(maxsize=None)
def _turned_words() -> Dict[str, str]:
    of_speaker, of_hearer = word_list("words_of_the_speaker"), word_list("words_of_the_hearer")
    return {
        **dict.fromkeys(word_list("speaker_subjects") + word_list("speaker_objects"), of_hearer[0]),
        **dict(zip(of_speaker, of_hearer)),
        **dict(zip(of_hearer, of_speaker)),
    }
