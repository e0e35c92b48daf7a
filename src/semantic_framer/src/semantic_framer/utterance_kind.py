"""What kind of utterance each clause is: a command, a request, a question, a report, a wish, a prohibition, or talk.

It is decided by mood, word order, auxiliaries, tense and subject, before any lexical unit is tried. What stands in front
of the verb of a clause is written in *formula words*: pronouns, auxiliaries and the like as they are, other verbs by
their lemma, a noun phrase as ``NP``, and the verb itself by its form (``BASE``, ``PAST`` ...). A clause acts only where
this is a formula of a command or a request: "BASE", "could you BASE", "i want you to BASE". Everything else with a
subject, an auxiliary or a question word in front of its verb asks or tells something.
"""

import re
from dataclasses import dataclass, replace
from enum import Enum
from typing import AbstractSet, Dict, FrozenSet, List, Optional, Pattern, Sequence, Tuple

from stanford_parser_ros.imperative import LEAD_IN
from stanford_parser_ros.tree import DependencyTree, Word

from semantic_framer import mood_words as words
from semantic_framer.clauses import RENEWING, Clause
from semantic_framer.lexicon import Lexicon
from semantic_framer.sentence import ASIDE, HEDGES, is_filler


class UtteranceKind(Enum):
    """What somebody does by saying something."""

    COMMAND = "command"
    REQUEST = "request"  # "could you ..."
    QUESTION = "question"
    REPORT = "report"  # what happens, happened, or is so
    WISH = "wish"  # of the speaker's own: "I want to go home"
    PROHIBITION = "prohibition"
    CORRECTION = "correction"  # "no, the office"
    ANSWER = "answer"  # no clause: "two feet"
    TALK = "talk"
    STOP = "stop"


@dataclass(frozen=True)
class KindVerdict:
    """The kind of a clause or an utterance, and why.

    Attributes:
        kind: what it is
        reason: name of the rule that says so
        positions: the words that it goes by
        is_fact: whether it says how something is now, which a unit may be about: "the mug is on the table"
        is_background: whether it has a subject and a verb of its own, and so may be said beside a command: "I'm thirsty"
    """

    kind: UtteranceKind
    reason: str
    positions: Tuple[int, ...] = ()
    is_fact: bool = False
    is_background: bool = False

    @property
    def acts(self) -> bool:
        """Whether it asks for something to be done."""
        return self.kind in (UtteranceKind.COMMAND, UtteranceKind.REQUEST, UtteranceKind.STOP)


#: What may stand between a formula and the verb: "could you *try to* ...".
_LEADING = (
    r"(?:(?:try|remember|go|come|make sure|help (?:me|us)"
    r"|be(?: (?:able|sure|kind|good|nice|willing|ready|careful)(?: enough)?)?)(?: (?:to|PREP))? )*"
)
_MODAL = "(?:can|could|will|would|may|might)"
#: What somebody is to do, or may do: "you should ...".
_TO_DO = (
    "(?:should|must|can|may|could|have to|need to|need|ought to|better|had better|would better|(?:have )?get(?:-ed)? to"
    "|are to|might want to)"
)
_I = "(?:i|we)"


def _formula(name: str, kind: UtteranceKind, pattern: str) -> Tuple[str, UtteranceKind, Pattern[str]]:
    return name, kind, re.compile(pattern)


#: Formulas that act, with the words that :func:`_formula_words` makes.
_ACTING: Tuple[Tuple[str, UtteranceKind, Pattern[str]], ...] = (
    # "Turn left", "please do turn left", "to turn left"
    _formula("imperative", UtteranceKind.COMMAND, f"(?:to |do )?{_LEADING}BASE"),
    # "You turn left"
    _formula("imperative_with_subject", UtteranceKind.COMMAND, f"you {_LEADING}BASE"),
    # "Let us turn left"
    _formula("adhortative", UtteranceKind.COMMAND, f"let us {_LEADING}BASE"),
    # "Could you turn left?"
    _formula("modal_to_addressee", UtteranceKind.REQUEST, f"(?:can|could|will|would|may) (?:you )?(?:NP )?{_LEADING}BASE"),
    # "Would you mind turning left?"
    _formula("minding", UtteranceKind.REQUEST, "(?:(?:would|do|will) )?(?:you )?mind GERUND"),
    # "Do you think you could turn left?"
    _formula(
        "thought_possible",
        UtteranceKind.REQUEST,
        f"(?:do )?(?:you )?(?:think|suppose) (?:that )?you {_MODAL} {_LEADING}BASE",
    ),
    # "May I ask you to turn left?"
    _formula(
        "leave_to_ask",
        UtteranceKind.REQUEST,
        f"{_MODAL} {_I} (?:ask|get|trouble|bother|have|want|request|beg) you (?:to )?{_LEADING}BASE",
    ),
    # "I want you to turn left", "I'm asking you to turn left"
    _formula(
        "wish_for_addressee",
        UtteranceKind.REQUEST,
        f"(?:{_I} )?(?:(?:do|would|will|am|are|must|have to|shall|have|been|go-ing to|gonna) )*"
        "(?:want|need|like|love|prefer|expect|require|ask|beg|order|command|request|urge|tell|wish|invite|advise|instruct)"
        f"(?:-ing)? (?:for )?you to {_LEADING}BASE",
    ),
    # "I'd prefer that you turn left", "I hope you can turn left"
    _formula(
        "wish_that_addressee",
        UtteranceKind.REQUEST,
        f"{_I} (?:(?:do|would|will|was|am) )*(?:prefer|ask|hope|wish|suggest|propose|recommend|insist|request|rather)"
        f"(?:-ing)? (?:that |if )?you (?:(?:should|would|could|can|will) )?{_LEADING}BASE",
    ),
    # "I think you should turn left"
    _formula(
        "opinion_on_addressee",
        UtteranceKind.REQUEST,
        f"{_I} (?:would )?(?:think|guess|suppose|believe|say|feel) (?:that )?you {_TO_DO} {_LEADING}BASE",
    ),
    # "You should turn left"
    _formula("duty_of_addressee", UtteranceKind.REQUEST, f"you {_TO_DO} {_LEADING}BASE"),
    # "I want the mug", "can I have the mug"
    _formula("wish_for_thing", UtteranceKind.REQUEST, f"(?:(?:{_MODAL} )?{_I} )?(?:(?:do|would|could|will) )*WISH"),
)
#: What somebody says of himself that he will, wants or has to do.
_INTENTION = re.compile(
    f"{_I} .*\\b(?:will|shall|would|should|must|can|could|may|might|to|am go-ing|gonna)\\b.*BASE"
    f"|{_I} .*\\b(?:like|love|plan|go|feel)(?:-ing)? (?:PREP )?GERUND"
)
#: A command right behind what cannot be followed by the base form of a verb: "I am tired *switch off the light*".
_RUN_ON = re.compile("(?:i|we|you|he|she|it|they|NP) (?:am|is|are|was|were) (?:(?!you|to|not|that)[a-z-]+ )?BASE")
_FACT = re.compile(
    "(?:NP|NP (?:PREP|of) NP|there|here|it|this|that|these|those|they|he|she)(?: NP)? "
    "(?:THIRD|BE|BASE|(?:is|are) (?:GERUND|PART))"
)


def kinds_of_clauses(
    tree: DependencyTree, hidden: AbstractSet[int], clauses: Sequence[Clause], lexicon: Lexicon
) -> Tuple[KindVerdict, ...]:
    """Decide of what kind each clause of a sentence is.

    Args:
        tree: the sentence
        hidden: positions of words that are said around it, were taken back, or are quoted
        clauses: its clauses
        lexicon: what was done by one of its verbs is no property of a thing: "the drawer is closed"
    Returns:
        a verdict for each clause
    """
    tops = _tops(tree, clauses)
    decided: Dict[int, KindVerdict] = {}
    for clause in sorted(clauses, key=lambda clause: clause.verb):
        if clause.verb in decided:  # a verb that is said once for two clauses
            continue
        front = _Front(tree, hidden, clause, tops, lexicon)
        same, joined = decided.get(front.same_clause()), decided.get(front.joined_to())
        if same is None and joined is not None and (front.is_watched() or front.is_renewed(joined)):
            joined = None
        decided[clause.verb] = same or joined or front.verdict()
    if any(verdict.acts for verdict in decided.values()):
        # "It's late, please open the door": "it" is nothing that was spoken of.
        for verb, verdict in decided.items():
            subjects = {child.form.lower() for child in tree.children(tops[verb]) if child.deprel.startswith("nsubj")}
            if verdict.is_fact and "it" in subjects:
                decided[verb] = replace(verdict, is_fact=False)
    return tuple(decided[clause.verb] for clause in clauses)


def kind_without_clause(tree: DependencyTree, hidden: AbstractSet[int]) -> KindVerdict:
    """Decide of what kind an utterance without a verb is."""
    said = [word for word in tree.words if word.index not in hidden and word.upos != "PUNCT"]
    spoken = [word for word in said if not is_filler(word.form)]
    forms = [word.form.lower() for word in spoken]
    if any(form in words.THANKS for form in forms[:3]):
        return KindVerdict(UtteranceKind.TALK, "thanks", _positions(spoken))
    if forms and all(form in words.CHATTER | words.GREETINGS for form in forms):
        is_greeting = any(form in words.GREETINGS for form in forms)
        return KindVerdict(UtteranceKind.TALK, "greeting" if is_greeting else "chatter", _positions(spoken))
    if forms and (forms[0] in words.QUESTION_WORDS or "?" in tree.text):
        return KindVerdict(UtteranceKind.QUESTION, "question_word", _positions(spoken[:1]))
    if forms and forms[0] in ("no", "nope", "not"):
        return KindVerdict(UtteranceKind.CORRECTION, "negated_fragment", _positions(spoken[:1]))
    return KindVerdict(UtteranceKind.ANSWER, "no_clause", _positions(spoken))


class _Front:
    """A clause from its first word to its verb."""

    def __init__(
        self, tree: DependencyTree, hidden: AbstractSet[int], clause: Clause, tops: Dict[int, int], lexicon: Lexicon
    ) -> None:
        self._lexicon = lexicon
        self._tree = tree
        self._clause = clause
        self._verb = tree.word(clause.verb)
        self._tops = tops
        self._top = tops[clause.verb]
        others = {top for top in tops.values() if top != self._top}
        inside = {word.index for word in tree.subtree(self._top)}
        for other in others & inside:
            inside -= {word.index for word in tree.subtree(other)}
        is_first = clause.verb == min(tops)
        self._is_front = is_first
        first = 1 if is_first else min(inside | {clause.verb})
        self._before = [word for word in tree.words[first - 1 : clause.verb - 1] if word.index not in hidden]
        self._behind = [word for word in tree.words[clause.verb :] if word.index in inside and word.index not in hidden]
        self._has_aside = any(
            word.deprel == ASIDE and word.form.lower() not in words.PADDING for word in tree.words[first - 1 : clause.verb - 1]
        )
        self._said = self._formula_words()

    def same_clause(self) -> int:
        """Return the verb that this one is below, 0 for none: "go" of "go to the kitchen to get the mug"."""
        return min((verb for verb, top in self._tops.items() if top == self._top and verb < self._clause.verb), default=0)

    def joined_to(self) -> int:
        """Return the verb before whose subject and auxiliaries may belong to this one as well, 0 for none."""
        top = self._tree.word(self._top)
        if top.deprel != "conj" or not top.head:
            return 0
        owner = _top(self._tree, top.head)
        return max((verb for verb, top in self._tops.items() if top == owner and verb < self._clause.verb), default=0)

    def is_renewed(self, before: KindVerdict) -> bool:
        """Whether a joined clause begins anew: by a subject, an auxiliary, "so" or "but", or as a command behind a
        statement that it cannot be a part of ("I'm tired and bring me water").
        """
        children = self._tree.children(self._top)
        if any(word.deprel.startswith("nsubj") or word.deprel.startswith("aux") for word in children):
            return True
        first = self._before[0].form.lower() if self._before else ""
        if any(child.form.lower() in RENEWING for child in children if child.index < self._clause.verb):
            return True
        if first in RENEWING:
            return True
        is_imperative = self._form() == "BASE"
        return is_imperative and before.reason in ("past", "perfect", "state", "fact", "progressive")

    def verdict(self) -> KindVerdict:
        """Decide by the words in front of the verb."""
        said = self._said
        if self.is_watched():
            return KindVerdict(UtteranceKind.REPORT, "complement", (self._clause.verb,))
        start = next((n for n, (text, _) in enumerate(said) if _is_decisive(text)), None)
        has_noun = any(text == "NP" for text, _ in said[: len(said) - 1 if start is None else start])
        if start is None:
            verdict = self._without_subject(has_noun)
        else:
            following = said[start + 1][0] if start + 1 < len(said) else ""
            is_inverted = said[start][0] in _AUXILIARIES and following in words.SUBJECT_PRONOUNS | {"not"}
            is_statement = has_noun and said[start][0] in _AUXILIARIES and not is_inverted
            if said[start][0] in words.SUBORDINATING and following not in _AUXILIARIES | {"BE", "PAST"}:
                # "Where the counter is" tells which place; "where is the counter" asks.
                return KindVerdict(UtteranceKind.REPORT, "subordinate_clause")
            verdict = self._with_subject(said[start:], is_statement)
        if verdict.acts and verdict.kind is UtteranceKind.COMMAND and self._has_aside:
            verdict = replace(verdict, kind=UtteranceKind.REQUEST, reason="request_formula")
        has_subject = has_noun or any(text in words.SUBJECT_PRONOUNS for text, _ in said)
        is_background = has_subject and verdict.kind in (UtteranceKind.REPORT, UtteranceKind.WISH, UtteranceKind.TALK)
        return replace(verdict, is_background=is_background)

    def _with_subject(self, said: List[Tuple[str, int]], is_statement: bool) -> KindVerdict:
        positions = tuple(index for _, index in said)
        text = " ".join(word for word, _ in said)
        if is_statement:
            return self._statement(f"NP {text}", positions)
        acting = _acting(text)
        if acting:
            return KindVerdict(acting[1], acting[0], positions)
        positive = _acting(text.replace("not ", ""))
        if positive and "not" in text.split():
            return KindVerdict(UtteranceKind.PROHIBITION, positive[0], positions)
        first = said[0][0]
        if first in words.QUESTION_WORDS:
            return KindVerdict(UtteranceKind.QUESTION, "question_word", positions)
        if first in _AUXILIARIES:
            return KindVerdict(UtteranceKind.QUESTION, "inversion", positions)
        return self._statement(text, positions)

    def _statement(self, text: str, positions: Tuple[int, ...]) -> KindVerdict:
        subject = text.split()[0]
        if any(word.form == "?" for word in self._behind):
            return KindVerdict(UtteranceKind.QUESTION, "question_mark", positions)
        is_negated = "not" in text.split() or subject == "nobody"
        if is_negated and self._form() in ("BASE", "GERUND") and re.search(r"(^|\b)you (.* )?(to )?BASE$", text):
            return KindVerdict(UtteranceKind.PROHIBITION, "negated_duty", positions)
        if self._form() == "BE":
            return self._state(subject, text, positions)
        if subject in words.SPEAKERS and (self._verb.lemma.lower() in words.SAYING or self._verb.upos == "AUX"):
            return KindVerdict(UtteranceKind.TALK, "opinion", positions)
        if subject in words.SPEAKERS and _INTENTION.fullmatch(text):
            return KindVerdict(UtteranceKind.WISH, "speaker_acts", positions)
        if _RUN_ON.fullmatch(text):
            return KindVerdict(UtteranceKind.COMMAND, "run_on", positions)
        if _FACT.fullmatch(text) and self._is_now(text):
            return KindVerdict(UtteranceKind.REPORT, "fact", positions, is_fact=True)
        reason = {"PAST": "past", "PART": "perfect", "GERUND": "progressive"}.get(self._form(), "statement")
        return KindVerdict(UtteranceKind.REPORT, reason, positions)

    def _is_now(self, text: str) -> bool:
        """Whether a statement without an auxiliary is no command to somebody: "the coats hang there", "Bob turn left"."""
        return not text.endswith("BASE") or self._verb.xpos == "VBP"

    def _state(self, subject: str, text: str, positions: Tuple[int, ...]) -> KindVerdict:
        """Decide of a clause with "be": where or what a thing is may be noted, how somebody feels is talk."""
        predicate = self._tree.word(self._top) if self._verb.deprel == "cop" else self._verb
        children = [child for child in self._tree.children(predicate.index)]
        is_place = predicate.form.lower() in words.PLACE_ADVERBS or any(child.deprel == "case" for child in children)
        is_place &= predicate.lemma.lower() not in words.MOODS
        has_clause = any(child.deprel.split(":")[0] in ("xcomp", "ccomp", "csubj", "advcl") for child in children)
        is_noun = predicate.upos in ("NOUN", "PROPN") and not any(child.deprel == "csubj" for child in children)
        is_person = subject in words.PERSONAL_PRONOUNS
        is_opinion = subject in words.OPINION_SUBJECTS and predicate.form.lower() in words.EVALUATIONS
        if (is_person and not is_place) or is_opinion:
            return KindVerdict(UtteranceKind.TALK, "state", positions)
        is_for_something = is_place and any(child.deprel == "acl" for child in children)
        if is_for_something or (has_clause and not is_noun) or (predicate.upos == "VERB" and self._verb.deprel == "cop"):
            return KindVerdict(UtteranceKind.REPORT, "state", positions)
        is_event = set(text.split()) & (_AUXILIARIES | {"not", "been", "being"}) or self._is_participle(predicate)
        is_fact = not is_event and not any(child.form.lower() == "being" for child in children)
        return KindVerdict(UtteranceKind.REPORT, "fact" if is_fact else "statement", positions, is_fact=is_fact)

    def _without_subject(self, has_noun: bool) -> KindVerdict:
        """Decide of a clause without a pronoun or an auxiliary in front of its verb."""
        said = self._said
        positions = tuple(index for _, index in said)
        form = self._form()
        subject = self._clause.subject
        is_negated = any(text == "not" for text, _ in said)
        is_place = any(text in ("here", "there") for text, _ in said)
        if form == "BE" and not has_noun and not is_place and self._is_front:
            return KindVerdict(UtteranceKind.QUESTION, "inversion", positions)
        if is_negated and form in ("BASE", "GERUND"):
            return KindVerdict(UtteranceKind.PROHIBITION, "negated", positions)
        if said[0][0] == "let" and len(said) > 1 and said[1][0] != "us":
            return KindVerdict(UtteranceKind.WISH, "let_me", positions)
        if form == "GERUND":
            return self._gerund(positions)
        is_spoken_to = not subject or self._tree.word(subject).form.lower() in words.ADDRESSEES | {"robot"}
        if form == "BASE" and (is_spoken_to or subject > self._clause.verb):
            text = " ".join(word for word, _ in said)
            if said[0][0] == "to" and self._verb.head > self._verb.index:
                return KindVerdict(UtteranceKind.TALK, "infinitive_subject", positions)
            if text.endswith(" to BASE") and not _acting(text):
                return KindVerdict(UtteranceKind.TALK, "infinitive", positions)
            return KindVerdict(UtteranceKind.COMMAND, "imperative", positions)
        if form == "WISH":
            return KindVerdict(UtteranceKind.REQUEST, "wish_for_thing", positions)
        start = next((n for n, (text, _) in enumerate(said) if text == "NP"), len(said) - 1)
        return self._statement(" ".join(text for text, _ in said[start:]), positions)

    def _gerund(self, positions: Tuple[int, ...]) -> KindVerdict:
        if self._verb.head > self._verb.index:
            return KindVerdict(UtteranceKind.REPORT, "gerund_subject", positions)
        others = [text for text, _ in self._said[:-1]]
        if others == ["mind"] or (self._has_aside and not others):
            return KindVerdict(UtteranceKind.REQUEST, "minding", positions)
        if others:
            return KindVerdict(UtteranceKind.TALK, "gerund", positions)
        return KindVerdict(UtteranceKind.REPORT, "bare_gerund", positions)

    def is_watched(self) -> bool:
        """Whether a verb says what somebody else does: "watch me *turn left*"."""
        top = self._tree.word(self._top)
        head = self._tree.word(top.head) if top.head else top
        before = self._tree.word(self._verb.index - 1) if self._verb.index > 1 else self._verb
        is_object = before.head == head.index and before.deprel in ("obj", "iobj") and before.upos in ("PRON", "PROPN")
        return head.lemma.lower() in words.WATCHING and is_object and self._verb_form() == "BASE"

    def _form(self) -> str:
        return self._said[-1][0]

    def _formula_words(self) -> List[Tuple[str, int]]:
        """Return the words in front of the verb, and the form of the verb, as formulas have them."""
        skipped = self._subordinate()
        said: List[Tuple[str, int]] = []
        for word in self._before:
            if word.index in skipped or word.upos == "PUNCT" or is_filler(word.form):
                continue
            text = _formula_word(word)
            if text and not (text == "NP" and said and said[-1][0] == "NP"):
                said.append((text, word.index))
        return said + [(self._verb_form(), self._verb.index)]

    def _is_participle(self, word: Word) -> bool:
        """Whether a predicate says what was done with a thing: "closed", "put on the table"."""
        form = word.form.lower()
        stems = (form[:-1], form[:-2], form[:-3], form[:-3] + "y") if form.endswith("ed") else ()
        return word.xpos in ("VBN", "VBG") or any(self._lexicon.verbs_beginning_with(stem) for stem in stems)

    def _subordinate(self) -> FrozenSet[int]:
        """Return the words of conditions and relative clauses that end in front of the verb."""
        found: FrozenSet[int] = frozenset()
        for word in self._before:
            relation = word.deprel.split(":")[0]
            if relation not in ("advcl", "acl"):
                continue
            marks = {child.form.lower() for child in self._tree.children(word.index)}
            inside = frozenset(other.index for other in self._tree.subtree(word.index))
            if self._verb.index not in inside and (relation == "acl" or marks & words.SUBORDINATORS):
                found |= inside
        return found

    def _verb_form(self) -> str:
        word, form, lemma = self._verb, self._verb.form.lower(), self._verb.lemma.lower()
        if lemma == "be":
            return "BASE" if form == "be" and not any(word.upos == "AUX" for word in self._before) else "BE"
        if lemma in words.WISHING and form == lemma:
            return "WISH"
        if form == lemma:
            is_helped = any(child.deprel.startswith("aux") for child in self._tree.children(word.index))
            if word.xpos == "VBN" and is_helped:
                return "PART"
            return "PAST" if word.xpos == "VBD" and self._clause.subject else "BASE"
        by_tag = {"VBZ": "THIRD", "VBD": "PAST", "VBN": "PART", "VBG": "GERUND"}
        if word.xpos in by_tag:
            return by_tag[word.xpos]
        return "GERUND" if form.endswith("ing") else "PAST" if form.endswith("ed") else "BASE"


_AUXILIARIES: FrozenSet[str] = words.MODALS | words.HAVE | words.DO | (words.BE - {"be", "been", "being"})


def _is_decisive(text: str) -> bool:
    """Whether a formula word tells that more than a command stands in front of a verb."""
    return text in words.SUBJECT_PRONOUNS or text in _AUXILIARIES or text in words.QUESTION_WORDS


def _acting(text: str) -> Optional[Tuple[str, UtteranceKind]]:
    return next(((name, kind) for name, kind, pattern in _ACTING if pattern.fullmatch(text)), None)


def _formula_word(word: Word) -> str:
    """Return how formulas have a word, empty for one that they do not have."""
    form = word.form.lower()
    said = words.FULL_FORMS.get(form, form)
    if word.deprel == "vocative" and said not in words.SUBJECT_PRONOUNS:
        return ""
    if said in words.NEGATING and word.upos != "INTJ":
        return "not"
    if said in words.HABITUAL:
        return "habit"
    if form in LEAD_IN | HEDGES or word.upos in ("INTJ", "CCONJ", "SYM"):
        return ""
    if said == "'s" and word.upos in ("AUX", "VERB"):
        return "is"
    if said == "'s" or word.xpos == "POS":
        return "" if word.upos == "PART" else "us"
    if said in words.QUESTION_WORDS | {"me", "us", "here", "better", "rather"}:
        return said
    if said in words.SUBJECT_PRONOUNS:
        return "NP" if word.deprel == "det" else said
    if said in _AUXILIARIES | {"be", "been", "being"} and (word.upos in ("AUX", "VERB") or word.xpos == "MD"):
        return said
    if word.upos == "ADV":
        return said if said in words.TELLING_ADVERBS else ""
    if said in ("to", "for", "that", "if"):
        return said
    if word.upos in ("ADP", "SCONJ"):
        return "PREP"
    if word.upos == "VERB":
        lemma = word.lemma.lower()
        suffix = {"VBG": "-ing", "VBD": "-ed", "VBN": "-ed", "VBZ": "-s"}.get(word.xpos, "")
        return lemma + (suffix if form != lemma else "")
    return said if word.upos == "ADJ" and word.deprel != "amod" else "NP"


def _top(tree: DependencyTree, index: int) -> int:
    """Return the highest word of the sentence, or of the part joined to it, that a word is in."""
    word = tree.word(index)
    while word.head and word.deprel.split(":")[0] not in ("conj", "parataxis", "list"):
        word = tree.word(word.head)
    return word.index


def _tops(tree: DependencyTree, clauses: Sequence[Clause]) -> Dict[int, int]:
    """Return the top of each clause by its verb; a verb that is joined to one of no clause belongs to the part of that:
    "we are going to go ahead and look".
    """
    tops = {clause.verb: _top(tree, clause.verb) for clause in clauses}
    for verb, top in tops.items():
        word = tree.word(top)
        while word.deprel == "conj" and _top(tree, word.head) not in tops.values():
            word = tree.word(_top(tree, word.head))
        tops[verb] = word.index
    return tops


def _positions(spoken: Sequence[Word]) -> Tuple[int, ...]:
    return tuple(word.index for word in spoken)
