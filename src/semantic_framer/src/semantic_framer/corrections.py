"""What is said against something that runs: prohibitions ("don't follow me") and corrections ("no, the office").

Inside of one utterance `repairs` carries a correction out. Here it is about an utterance of its own, and the framer does
not know what runs: a refusal gets the code that says what it was, and who knows what runs acts on it.
"""

import re
from typing import FrozenSet, Optional

from stanford_parser_ros.imperative import LEAD_IN
from stanford_parser_ros.tree import DependencyTree, Word

from semantic_framer.asides import set_aside
from semantic_framer.lexicon import Lexicon
from semantic_framer.sentence import ASIDE, is_filler

#: The codes of refusals that are against something that runs.
PROHIBITION = "NEGATED"
CORRECTION = "CORRECTION"
#: What a person says who answers no, or takes back what they were saying: nothing that runs is meant.
DECLINED = "DECLINED"

#: Refusals that may be corrections; what is unknown only for now (UNKNOWN_FRAME) is none of them.
_UNCLEAR = frozenset(["NO_VERB", "UNKNOWN_VERB", "LEFT_OVER_WORDS", "NO_READING", "CONDITION", PROHIBITION])
_OBJECTION = "(no|nope|nah|wrong)"
_MEANT = "i (really |actually )?(mean|meant|said|wanted)( to say)?"
_AROUND = "(oh|ah|hey|well|wait|robot|sorry|oops|please|actually|,)"
_SET_OFF = "(wait|please|just|now|then|instead|rather)"
#: What may stand in front of the command that a correction is: "no, ..." and "no I meant ...", but not "no ...", which
#: may forbid.
_OPENING = re.compile(
    f"({_AROUND} )*({_OBJECTION} (({_AROUND}|{_OBJECTION}) )*(,|{_OBJECTION}|{_SET_OFF}|{_MEANT})|{_MEANT})"
    f"( ({_AROUND}|{_SET_OFF}))*"
)
_CORRECTIONS = re.compile(
    "|".join(
        [
            f"({_AROUND} )*({_OBJECTION}|not|{_MEANT}|(the )?other (one|way|side|direction|hand)|forget)( .*)?",
            "(oops|sorry|actually|rather|instead)( ,)? .+",
            f".+ (instead|rather|{_MEANT})",
            "(.+ )?wrong( .+)?",
            "(that|this) ('s|is|was) (not|n't) .+|(that|this) (is|was) n't .+|(it|you) ('s|is|'re|are) (not|n't) "
            "(there|here|that|this|right|the) ?.*",
            "i do (not|n't) (want|need|like) (to|that|this) ?.*",
        ]
    )
)
#: "Left, not right", where there is no verb that is negated.
_CONTRASTS = re.compile("[^ ]+( [^ ]+){0,3} (, )?not .+")
#: Corrections whatever else they might mean.
_CLEAR = re.compile("(no )?(, )?(that|this|it|you) ('s|is|'re|are) (all |completely |totally )?(wrong|not right|n't right|the wrong .+)")
#: Talk with a no that is against nothing.
_TALK = re.compile(
    "(no|not) (thanks|thank|problem|problems|worries|worry|idea|doubt|hurry|rush|need|matter|bad|yet|sure|now|one|body|"
    "at all)( .*)?"
)
#: Not to do these is to go on.
_ENDING = "(stop|halt|pause|wait|hesitate|worry|forget|hurry|rush|panic|mind|freeze|quit|cancel|abort|bother|hold on)"
_GOING_ON = re.compile(
    f"(({_AROUND}|and|but|so|ok|okay|just|now|{_OBJECTION}) )*((you )?(must|should|can|may|need) (not|n't)|do (not|n't)|never)"
    f"( you| ever| just| please| even)* {_ENDING}( .*)?"
)
_FORBIDDING = re.compile("(^| )(not|n't|never)( |$)")
_NO_DOING = re.compile(r"no( more)? \w+ing( |$)")
_ASKING = re.compile(
    "(is|are|am|was|were|do|does|did|have|has|had) (?!not |n't )|(what|where|who|how|when|which) |why (?!do n't|not )"
)
_NOBODY = frozenset(["nobody", "none", "noone"])
_WISHING = frozenset("want need like ask tell say wish wonder expect mean think believe".split())
_REPORTING = re.compile("(^| )(did|was|were|has|had|been|'ve|have(?! to))( |$)")


def without_objection(tree: DependencyTree, lexicon: Lexicon) -> DependencyTree:
    """Set aside what a correction opens with where a whole command follows: "no, turn right", "I meant turn right".

    Args:
        tree: the sentence
        lexicon: its verbs tell where a command begins
    Returns:
        the sentence, with the same words in the same places
    """
    text = ""
    for position, word in enumerate(tree.words):
        if position and _OPENING.fullmatch(text) and _begins_command(tree, position, lexicon):
            return set_aside(tree, frozenset(range(1, position + 1)), lexicon, ASIDE)
        text = f"{text} {_plain(word)}".strip()
    return tree


def code_of(tree: DependencyTree, code: str) -> Optional[str]:
    """Find out what a refusal is against.

    Args:
        tree: the sentence
        code: of the refusal, as it was made
    Returns:
        `PROHIBITION` or `CORRECTION`; "NO_READING" for a negation that forbids nothing; None for any other refusal
    """
    text = " ".join(_plain(word) for word in tree.words).strip(" ,")
    if _CLEAR.fullmatch(text):
        return CORRECTION
    if code not in _UNCLEAR:
        return None
    if _GOING_ON.fullmatch(text) or _TALK.fullmatch(text):
        return "NO_READING" if code == PROHIBITION else None
    if _NO_DOING.match(text):
        return PROHIBITION
    is_forbidden = code == PROHIBITION and _FORBIDDING.search(text)
    if _CORRECTIONS.fullmatch(text) and not is_forbidden:
        return CORRECTION
    if code != PROHIBITION:
        return CORRECTION if _CONTRASTS.fullmatch(text) else None
    if _ASKING.match(text) or _is_statement(tree):
        return CORRECTION if _CORRECTIONS.fullmatch(text) else "NO_READING"
    return PROHIBITION


def is_objection(tree: DependencyTree) -> bool:
    """Whether a sentence opens with an objection: "no, turn", which is asked about."""
    words = [_plain(word) for word in tree.words if word.upos != "PUNCT" and not is_filler(word.form)]
    return bool(words) and re.fullmatch(_OBJECTION, words[0]) is not None


def _plain(word: Word) -> str:
    form = word.form.lower().replace("\u2019", "'")
    return "," if word.upos == "PUNCT" else "n't" if form == "nt" else form


def _begins_command(tree: DependencyTree, position: int, lexicon: Lexicon) -> bool:
    words = [word for word in tree.words[position:] if word.upos != "PUNCT" and word.form.lower() not in LEAD_IN]
    return bool(words) and any(
        lexicon.verbs_beginning_with(spelling) for spelling in (words[0].form.lower(), words[0].lemma.lower())
    )


def _is_statement(tree: DependencyTree) -> bool:
    """Whether it is told or asked that something is not so: "I don't know"; "I don't want you to" forbids."""
    root = next(word for word in tree.words if word.head == 0)
    forms = [_plain(word) for word in tree.words]
    subject = next((word for word in tree.children(root.index) if word.deprel.startswith("nsubj")), None)
    if subject is None:
        return False
    behind: FrozenSet[str] = frozenset(forms[subject.index :])
    if _plain(subject) in ("you", "u", "robot"):
        return _REPORTING.search(" ".join(forms)) is not None
    is_wish = root.lemma.lower() in _WISHING or _plain(subject) in _NOBODY
    return not (is_wish and "you" in behind)
