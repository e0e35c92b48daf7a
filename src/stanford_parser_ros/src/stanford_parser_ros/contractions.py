"""Words that are said, and often written, as one: "gonna", "didja", "dont".

A tokenizer that learned from text knows "going to", "did you" and "don't". Speech recognisers write the short forms, and
leave apostrophes out.
"""

import re
from typing import Dict, Match

#: Written without the apostrophe, by what stands in front of it.
_WITHOUT_APOSTROPHE: Dict[str, str] = {
    **{
        f"{verb}nt": f"{verb}n't"
        for verb in "do does did is are was were have has had would could should might must need wo ca ai".split()
    },
    **{f"{verb}ve": f"{verb}'ve" for verb in "i you we they could would should might must".split()},
    **{f"{subject}re": f"{subject}'re" for subject in ("you", "they")},
    **{f"{subject}ll": f"{subject}'ll" for subject in ("you", "they", "it", "that")},
    **{f"{subject}s": f"{subject}'s" for subject in "he she that what where who how there here let".split()},
    "im": "i'm",
    "youd": "you'd",
}
#: Said as one word.
_SAID_AS_ONE: Dict[str, str] = {
    **{
        f"{verb}{you}": f"{verb} you"
        for verb in ("could", "would", "can", "will", "do", "did", "should")
        for you in ("ya", "ja", "cha")
    },
    "d'you": "do you",
    "d'ya": "do you",
    "dyou": "do you",
    "dontcha": "don't you",
    "don'tcha": "don't you",
    "whatcha": "what are you",
    "whaddya": "what do you",
    "wanna": "want to",
    "gonna": "going to",
    "gotta": "have to",
    "hafta": "have to",
    "oughta": "ought to",
    "tryna": "trying to",
    "lemme": "let me",
    "gimme": "give me",
    "outta": "out of",
    "goto": "go to",
    "cmon": "come on",
    "c'mon": "come on",
}
_FULL = {**_WITHOUT_APOSTROPHE, **_SAID_AS_ONE}
_WORDS = "|".join(sorted(map(re.escape, _FULL), key=len, reverse=True))
#: "Id" is a word of its own unless a wish follows.
CONTRACTION = re.compile(
    rf"(?<![\w'-])(?:{_WORDS}|id(?= (?:like|love|prefer|appreciate|rather|be|want)\b))(?![\w'-])", re.IGNORECASE
)


def written_out(short: Match[str]) -> str:
    """Return the words of a contraction, with the capital that it began with."""
    text = short.group(0)
    full = _FULL.get(text.lower(), "i'd")
    return full[0].upper() + full[1:] if text[0].isupper() else full
