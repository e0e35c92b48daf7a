"""The verb in the name of a frame: "wave" for "waving"."""

import re
from typing import Callable, List, Optional

_VOWELS = "aeiou"
#: Stems that no English verb ends with, so that "e" was dropped.
_NEEDS_E = re.compile(
    r"[vcu]$|[^z]z$|[bcdfgkptz]l$|(ch|r)ang$|(ea|au|ai|oo|ou)s$|[tl][ou]r$|uid$|[lnr]s$|[aeiou]rg$|dg$"
)
#: Ends of stems of several syllables that had an "e".
_LONG_WITH_E = re.compile(r"(at|ut|id|ir|in|iz|ar|ag|ul|as|os|us)$")


def verb_of(name: str, is_verb: Callable[[str], bool] = lambda word: False) -> Optional[str]:
    """Return the verb that the name of a frame has, in its base form.

    Args:
        name: of a frame; its first word that ends with "ing" is the verb, otherwise a name of one word
        is_verb: whether a word is known as a verb; such a word comes first
    Returns:
        the verb; None when no word of the name is one
    """
    words = name.split("_")
    for word in words:
        stem = word[:-3]
        if word.endswith("ing") and re.search(f"[{_VOWELS}y]", stem):
            return next((base for base in _possible_bases(stem) if is_verb(base)), _likely_base(stem))
    return words[0] if len(words) == 1 else None


def _possible_bases(stem: str) -> List[str]:
    undoubled = [stem[:-1]] if stem[-1:] == stem[-2:-1] else []
    return [*undoubled, stem, stem + "e"]


def _likely_base(stem: str) -> str:
    """Return the base form by the rules of spelling. Some stems ("bath") have two; a person sees the result."""
    if stem.endswith("y") and len(stem) < 3:
        return stem[:-1] + "ie"  # lying
    if re.search(r"([bdgmnprt])\1$", stem):
        return stem[:-1]  # running
    if _NEEDS_E.search(stem):
        return stem + "e"  # waving, dancing, rescuing, handling, changing
    vowels = re.findall(f"[{_VOWELS}]+", stem)
    ends_open = re.search(f"(^|[^{_VOWELS}])[{_VOWELS}][^{_VOWELS}wxy]$", stem)
    if ends_open and (len(vowels) == 1 or _LONG_WITH_E.search(stem)):
        return stem + "e"  # taking, navigating
    return stem
