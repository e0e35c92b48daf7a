"""What is said around a command: "could you please ...", "I was wondering if you could ...", "..., robot".

A parser that learned from text, in which commands are rare, parses such a command worse than the command alone: so it
gets the command alone, and the words around it, whose analysis is known, are put around its tree. What is only said
around it becomes an *aside* of its verb; in "could you" the modal is the auxiliary of the verb, and "you" its subject.
"""

import re
from dataclasses import dataclass, replace
from typing import Dict, FrozenSet, List, Mapping, Optional, Sequence, Tuple

from stanford_parser_ros.imperative import LEAD_IN
from stanford_parser_ros.spelling import Spelling
from stanford_parser_ros.tree import DependencyTree, Word

#: Relation of what is only said around a command ("if you don't mind") to its verb.
ASIDE = "discourse:aside"
#: Said anywhere in a formula without changing it.
_PADDING = frozenset("please just really very so kindly maybe perhaps possibly actually also quite".split())
_NOT = "(n't|not|nt)"
_COULD = "(could|can|would|will|might)"
_YOU = f"({_COULD} you )?"
_I = "(i|we)"
_AM = f"{_I} (am|'m|are|'re|was|were)"
_WOULD = "(would|'d|will|'ll)"
#: What may lead to a command, in words with a blank between them and without padding; a verb of the lexicon must follow.
_OPENINGS = re.compile(
    "|".join(
        [
            f"why do {_NOT} (you|we)",
            "(how|what) about (if )?(you|we)",
            f"{_AM} (wondering|hoping|thinking) (if |whether |that )?you {_COULD}",
            f"{_I} (wonder|hope) (if |whether |that )?you {_COULD}",
            f"{_AM} going to ask (if|whether) you {_COULD}",
            f"{_AM} going to (ask|need|want) you to",
            f"{_I} (am|'m|are|'re) (asking|begging|telling|ordering|instructing|commanding) you to",
            f"({_I} )?({_WOULD} |do |must |have to )?"
            "(want|need|like|love|prefer|expect|ask|beg|order|command|request|require|urge|instruct|advise|invite) "
            "(for )?you to",
            f"{_I} ({_WOULD} )?(prefer|ask|request|suggest|propose|recommend|insist|demand) (that |it if |if )?"
            "you( should| could| would)?",
            f"{_I} ({_WOULD} )?(think|guess|suppose|believe|say|feel) (that )?"
            "(you|we) (should|could|can|might|must|ought to|need to|have to|had better|'d better|better)",
            "(i think )?(you|we) (had better|'d better|ought to)",
            "what i (need|want|would like|'d like) (you to do is|is for you)( to)?",
            "(your|the) (next |first )?(task|job|mission|order) is( for you)? to",
            "all you (have|need) to do is( to)?",
            f"(do )?(you )?(think|suppose|reckon) (that )?you {_COULD}",
            "(is it|would it be|will it be) possible (for you )?to",
            "would it be (ok|okay|fine|alright) for you to",
            f"(is it|would it be) (possible|ok|okay|fine|alright) if you {_COULD}",
            f"it {_WOULD} be (a )?(great|big|huge|nice|good|lovely|kind|helpful|wonderful|awesome|perfect)?( help| favor"
            f"| favour)? if you {_COULD}",
            f"it {_WOULD} (help|mean)( me| us)?( a lot| the world)? if you {_COULD}",
            f"{_I} {_WOULD} (appreciate|like|love) it if you {_COULD}",
            f"{_I} {_WOULD} be (grateful|happy|glad|thankful|obliged|pleased|delighted) if you {_COULD}",
            f"(could|can|may|might) {_I} (ask|get|trouble|bother|have) you to",
            f"{_YOU}do (me|us) (a|the) (big |little |small |quick |huge )?(favor|favour)( and)?",
            f"{_YOU}be (a|an) (good )?(dear|darling|angel|sweetheart|sport|pal|star|robot) and",
            f"{_YOU}be (kind|good|nice) (enough )?(as )?(to|and)",
            f"{_YOU}be (willing|prepared|happy) to",
            f"{_YOU}(make|be) sure (to|and|that you|you)",
            f"{_YOU}see to it that you",
            f"{_YOU}go (ahead|on) and",
            f"do {_NOT} forget to",
            "(are|would|might) you (be )?able to",
            f"(is there )?(any|a) (chance|way|possibility) (that )?you {_COULD}",
            "feel free to",
            "quick",
            "hurry( up)?( and)?",
            "help (me|us)( out and| out| to)?",
            "let 's",
            "you know what",
            "(excuse|pardon) me( but)?",
            "good (morning|afternoon|evening|day)",
        ]
    )
)
#: In front of a verb they doubt it: "can you really turn".
_DOUBTING = frozenset(["really", "quite"])
#: The auxiliary and the subject of the command itself.
_MODAL = re.compile("(can|could|will|would|may) you")
#: In front of a gerund: "would you mind turning left".
_MINDING = re.compile("(would|do|will) you mind|you (would|do) not mind")
#: No formula has more words.
_LONGEST = 14
#: In front of all that.
_POLITE = re.compile(
    "|".join(
        [
            f"if (you|that|it) (do|does|would) {_NOT} mind( that)?",
            "(when|whenever|if) you (get|have|find|'ve got) (a |some |the )?(chance|moment|minute|second|sec|time)",
            "if (it|that) (is|'s) (ok|okay|alright|fine|not too much (trouble|to ask))( with you)?",
            "as (soon|quickly|fast) as (you (can|could)|possible)",
            "right away|straight away|at once|immediately",
        ]
    )
)
#: What may stand behind a command; some only behind a comma: "follow the robot", "say thank you".
_ENDING = re.compile(
    "(, )?((would|could|will|can) you( please)?|please|if you please|right away|immediately|at once|straight away)"
    "|, (please|robot|thanks|thank you|now|my friend)( (robot|please|very much|so much|a lot))?"
)
#: As they begin a clause they are auxiliaries, and no verb of a command: "could you have opened it".
_NO_COMMANDS = frozenset(["be", "have", "do"])
#: Behind one of these a word is no command: "name is Bob".
_FINITE = frozenset(["is", "are", "was", "were", "'s"])
_MARKS = (".", "?", "!")
_TOKEN = re.compile(r"\w+?(?=n't\b)|n't\b|'(?:m|re|ve|ll|d|s)\b|[\w-]+|[^\w\s]")
_TAGS: Dict[str, Tuple[str, str]] = {"aux": ("AUX", "MD"), "nsubj": ("PRON", "PRP"), "vocative": ("NOUN", "NN")}


@dataclass(frozen=True)
class Surroundings:
    """A command, and what is said around it.

    Attributes:
        before: words in front of the command; all hang on its verb
        command: the spelling of the command alone, as a plain command is written
        verb: the form that its verb has here: "scrubbing" of "would you mind scrubbing"
        base: its base form
        behind: words behind the command, with the mark at the end of the utterance
    """

    before: Tuple[Word, ...]
    command: Spelling
    verb: str
    base: str
    behind: Tuple[Word, ...]


@dataclass(frozen=True)
class _Token:
    form: str
    start: int
    end: int

    @property
    def said(self) -> str:
        return self.form.lower()


def is_opening(forms: Sequence[str]) -> bool:
    """Whether words are a formula that leads to a command."""
    return _OPENINGS.fullmatch(_formula(forms)) is not None


def surroundings(spelling: Spelling, verbs: FrozenSet[str]) -> Optional[Surroundings]:
    """Find what is said around a command.

    Args:
        spelling: of the utterance
        verbs: known verbs in their base form, lower case
    Returns:
        the words around it and the command; None where nothing is said around it, or no known verb begins it
    """
    tokens = [_Token(match.group(), *match.span()) for match in _TOKEN.finditer(spelling.text)]
    front = _front(tokens, 0, verbs)
    if front is None:
        return None
    verb, base, relations = front.verb, front.base, front.relations
    end = _ending(tokens, verb)
    if not verb and end == len(tokens) - (tokens[-1].form in _MARKS):
        return None
    return Surroundings(
        tuple(_word(token, spelling, relations.get(number, "")) for number, token in enumerate(tokens[:verb])),
        _command(spelling, tokens[verb], base, tokens[end - 1].end),
        tokens[verb].form,
        base,
        tuple(_word(token, spelling, "" if token.said == "robot" else ASIDE) for token in tokens[end:]),
    )


@dataclass(frozen=True)
class _Front:
    """Where the verb of a command stands, its base form, and the relations of formula words in front of it."""

    verb: int
    base: str
    relations: Mapping[int, str]


def _front(tokens: Sequence[_Token], start: int, verbs: FrozenSet[str], *, is_minding: bool = False) -> Optional[_Front]:
    """Find the verb of a command behind any number of formulas."""
    first = _behind(tokens, start, LEAD_IN | _PADDING)
    base = _base(tokens, first, verbs, is_minding)
    if base:
        return _Front(first, base, {})
    for behind in range(min(len(tokens), first + _LONGEST), first, -1):
        forms = [token.said for token in tokens[first:behind]]
        if forms[-1] in _PADDING | {","}:
            continue
        text = _formula(forms)
        is_modal, minds = _MODAL.fullmatch(text) is not None, _MINDING.fullmatch(text) is not None
        following = tokens[behind].said if behind < len(tokens) else ""
        if is_modal and following in _DOUBTING:
            return None
        found = (
            _front(tokens, behind, verbs, is_minding=minds)
            if is_modal or minds or is_opening(forms) or _POLITE.fullmatch(text)
            else None
        )
        if found is not None and not (is_modal and found.relations):
            relations = {
                number: ("nsubj" if tokens[number].said == "you" else "aux") if is_modal else ASIDE
                for number in range(first, behind)
                if tokens[number].said not in _PADDING
            }
            return _Front(found.verb, found.base, {**relations, **found.relations})
    return None


def surrounded(tree: DependencyTree, around: Surroundings, text: str) -> DependencyTree:
    """Put the words that are said around a command around its tree.

    Args:
        tree: the parse of the command alone
        around: what is said around it
        text: the whole utterance
    """
    shift = len(around.before)
    command = [replace(word, index=word.index + shift, head=word.head and word.head + shift) for word in tree.words]
    if command[-1].upos == "PUNCT" and command[-1].form == ".":
        command.pop()
    is_gerund = around.verb.lower() != around.base
    command[0] = replace(
        command[0], form=around.verb, lemma=around.base, xpos="VBG" if is_gerund else command[0].xpos
    )
    root = next(word.index for word in command if word.head == 0)
    words = [*around.before, *command, *around.behind]
    return DependencyTree(
        text=text,
        words=tuple(
            replace(word, index=number, head=word.head if word in command else root)
            for number, word in enumerate(words, start=1)
        ),
    )


def _formula(forms: Sequence[str]) -> str:
    said = (form.lower().replace("’", "'") for form in forms)
    return " ".join(form for form in said if form not in _PADDING and form != ",")


def _behind(tokens: Sequence[_Token], position: int, skipped: FrozenSet[str]) -> int:
    while position < len(tokens) and (tokens[position].said in skipped or tokens[position].form == ","):
        position += 1
    return position


def _base(tokens: Sequence[_Token], verb: int, verbs: FrozenSet[str], is_gerund: bool) -> str:
    """Return the base form of the verb of a command; empty where no known one stands there."""
    form = tokens[verb].said if verb < len(tokens) else ""
    following = tokens[verb + 1].said if verb + 1 < len(tokens) else ""
    if form in _NO_COMMANDS or following in _FINITE:
        return ""
    if not is_gerund:
        return form if form in verbs else ""
    stem = form[:-3] if form.endswith("ing") else ""
    return next((base for base in bases_of_gerund(stem) if base in verbs), "")


def _ending(tokens: Sequence[_Token], verb: int) -> int:
    """Return the position behind the last word of the command."""
    last = len(tokens) - (tokens[-1].form in _MARKS)
    for end in range(verb + 3, last):
        if _ENDING.fullmatch(" ".join(token.said for token in tokens[end:last])):
            return end
    return last


def bases_of_gerund(stem: str) -> List[str]:
    """Return what may have been in front of "ing": "scrub" for "scrubb", "bake" for "bak"."""
    doubled = [stem[:-1]] if stem[-1:] == stem[-2:-1] else []
    tied = [stem[:-1] + "ie"] if stem.endswith("y") else []
    return [stem, stem + "e", *doubled, *tied] if len(stem) > 1 else []


def _command(spelling: Spelling, verb: _Token, base: str, end: int) -> Spelling:
    """Return the command alone, written as the plain command would be, with the mark that the utterance ends with."""
    written = base[0].upper() + base[1:] if spelling.text[:1].isupper() else base
    mark = "." if spelling.text[-1:] in _MARKS else ""
    start, stop = spelling.origins[verb.start], spelling.origins[end]
    return Spelling(
        written + spelling.text[verb.end : end] + mark,
        (start,) * len(base) + spelling.origins[verb.end : end] + (stop,) * (1 + len(mark)),
    )


def _word(token: _Token, spelling: Spelling, relation: str) -> Word:
    said = token.said
    if re.fullmatch(r"\W", said):
        upos, xpos, relation = "PUNCT", "." if said in _MARKS else ",", "punct"
    elif not relation:
        relation = "vocative" if said == "robot" else ASIDE if said in _PADDING - {"please"} else "discourse"
    if relation != "punct":
        upos, xpos = _TAGS.get(relation, ("INTJ", "UH"))
    return Word(
        index=0,
        form=token.form,
        lemma=said,
        upos=upos,
        xpos=xpos,
        feats="",
        head=0,
        deprel=relation,
        start_character=spelling.origins[token.start],
        end_character=spelling.origins[token.end],
    )
