"""Decides the kind of each clause: a command, a request, a question, a report, a wish, a prohibition, or talk.

Mood, word order, auxiliaries, tense and subject decide the kind before any lexical unit is tried. The words before the
verb of a clause become *formula words* (``moods.yaml``), and the verb itself becomes its form. A clause acts only if
these words match a formula of a command or a request: "BASE", "could you BASE", "i want you to BASE". Any other clause
with a subject, an auxiliary or a question word before its verb asks or tells something.
"""

from dataclasses import dataclass, replace
from typing import Dict, FrozenSet, List, Optional, Sequence, Tuple

from semantic_framer.kinds.mood_file import MoodRule, UtteranceKind, shipped_moods
from utterance_passes.phrases.clauses import Clause
from utterance_passes.trees.formula_file import is_filler
from utterance_passes.trees.persons import is_abstract
from utterance_passes.trees.tree import ASIDE, NOUNS, VERBS, DependencyTree, Word
from utterance_passes.trees.vocabulary import Vocabulary
from word_classes import word_class

_AUXILIARIES = word_class("modals") | word_class("forms_of_have") | word_class("forms_of_do")
_BE = word_class("forms_of_be")
_CHATTER = word_class("chatter")
_CONDITIONS = word_class("conditions") | word_class("reason_conjunctions")
_GREETINGS = word_class("greetings")
_HABITUAL = word_class("habitual_adverbs")
_HEARERS = word_class("hearers") | {"robot"}
_LEFT_AND_RIGHT = word_class("left_and_right")
_MODALS = word_class("modals")
_NEGATING = word_class("negations") - word_class("subject_pronouns")
_NONFINITE_BE = word_class("nonfinite_forms_of_be")
_OBJECTS = word_class("speaker_objects")
_OPINION_SUBJECTS = word_class("pronouns_of_things")
_OPINION_VERBS = word_class("opinion_verbs")
_PADDING = word_class("padding")
_PERSONS = word_class("pronouns_of_persons") - word_class("plural_pronouns")
_PLACE_ADVERBS = word_class("place_adverbs")
_QUESTION_WORDS = word_class("question_words")
RENEWING = word_class("clause_borders") - word_class("words_between_commands") - {"or"}
_SAID_AROUND = word_class("lead_in") | word_class("hedges")
_SPEAKER_POSSESSORS = word_class("words_of_the_speaker")
_SPEAKERS = word_class("speaker_subjects")
_SUBJECTS = word_class("subject_pronouns")
_SUBORDINATING = word_class("relative_adverbs")
_THANKS = word_class("thanks")
_WANTING = word_class("wanting_verbs")
_WATCHING = word_class("verbs_with_verbs")
#: Places before "be": "here is the kitchen", "there are two chairs".
_SHOWN = frozenset(["here", "there"])
#: After a clause with one of these verb forms, a base form starts a new clause: "I'm tired *and bring me water*".
_FINISHED = frozenset(["PAST", "PART", "GERUND", "BE", "THIRD"])
_FORM_OF_TAG = {"VB": "BASE", "VBZ": "THIRD", "VBD": "PAST", "VBN": "PART", "VBG": "GERUND"}
_REMARKS = frozenset(["it BE", "i BE", "we BE"])
_SUFFIX_OF_TAG = {"VBG": "-ing", "VBD": "-ed", "VBN": "-ed", "VBZ": "-s"}


@dataclass(frozen=True)
class KindVerdict:
    """The kind of a clause or an utterance, and why.

    Attributes:
        kind: the kind
        reason: name of the rule that decided
        words: the formula words that the rule matched
        is_fact: whether it describes a present state, which a unit may be about: "the mug is on the table"
        is_background: whether it has its own subject and verb, and may accompany a command: "I'm thirsty"
    """

    kind: UtteranceKind
    reason: str
    words: str = ""
    is_fact: bool = False
    is_background: bool = False

    def __str__(self) -> str:
        return f"{self.kind.value}: {self.reason}, {self.words}" if self.words else f"{self.kind.value}: {self.reason}"

    @property
    def is_remark(self) -> bool:
        """Whether it only says how the speaker or something is: "it's so heavy", "I'm thirsty"."""
        return self.words in _REMARKS

    @property
    def acts(self) -> bool:
        """Whether it asks the robot to do something."""
        return self.kind in (UtteranceKind.COMMAND, UtteranceKind.REQUEST)

    @property
    def is_read(self) -> bool:
        """Whether to try lexical units: for an action, for a fact, or to find out what a prohibition forbids."""
        return self.acts or self.is_fact or self.kind is UtteranceKind.PROHIBITION


def kinds_of_clauses(
    tree: DependencyTree, clauses: Sequence[Clause], vocabulary: Vocabulary
) -> Tuple[KindVerdict, ...]:
    """Decide the kind of each clause of a sentence.

    Args:
        tree: the sentence
        clauses: its clauses
        vocabulary: a participle of one of its verbs is an event, not a property: "the drawer is closed"
    Returns:
        a verdict for each clause
    """
    tops = _tops(tree, clauses)
    decided: Dict[int, KindVerdict] = {}
    for clause in sorted(clauses, key=lambda clause: clause.verb):
        front = _Front(tree, clause, tops, vocabulary)
        same, joined = decided.get(front.same_clause()), decided.get(front.joined_to())
        if same is None and joined is not None and (front.is_watched() or front.is_renewed(joined)):
            joined = None
        decided.setdefault(clause.verb, same or joined or front.verdict())
    if any(verdict.acts for verdict in decided.values()):
        # "It's late, please open the door": "it" does not refer to a thing. "My hands are full, ..." is a reason.
        for verb, verdict in decided.items():
            subjects = [child for child in tree.children(tops[verb]) if child.deprel.startswith("nsubj")]
            owners = {child.said for subject in subjects for child in tree.children(subject.index)}
            is_mine = tree.word(tops[verb]).upos == "ADJ" and bool(owners & _SPEAKER_POSSESSORS)
            if verdict.is_fact and (is_mine or any(subject.said == "it" for subject in subjects)):
                decided[verb] = replace(verdict, is_fact=False)
    return tuple(decided[clause.verb] for clause in clauses)


def kind_without_clause(tree: DependencyTree) -> KindVerdict:
    """Decide the kind of an utterance without a verb."""
    hidden = tree.abandoned | tree.quoted | tree.fillers
    said = [word for word in tree.words if word.index not in hidden and word.upos != "PUNCT"]
    forms = [word.said for word in said]
    text = " ".join(forms)
    # "Right" alone may answer "left or right?".
    is_chatter = bool(frozenset(forms) - _LEFT_AND_RIGHT) and frozenset(forms) <= _CHATTER | _GREETINGS | _THANKS
    if _THANKS & frozenset(forms[:1]) or (is_chatter and _THANKS & frozenset(forms)):
        return KindVerdict(UtteranceKind.TALK, "thanks", text)
    if is_chatter:
        is_greeting = bool(_GREETINGS & frozenset(forms))
        return KindVerdict(UtteranceKind.TALK, "greeting" if is_greeting else "chatter", text)
    if forms and (forms[0] in _QUESTION_WORDS or tree.text.rstrip().endswith("?")):
        return KindVerdict(UtteranceKind.QUESTION, "question_word", text)
    return KindVerdict(UtteranceKind.ANSWER, "no_clause", text)


class _Front:
    """A clause from its first word to its verb."""

    def __init__(self, tree: DependencyTree, clause: Clause, tops: Dict[int, int], vocabulary: Vocabulary) -> None:
        self._tree = tree
        self._clause = clause
        self._verb = tree.word(clause.verb)
        self._tops = tops
        self._top = tops[clause.verb]
        self._vocabulary = vocabulary
        self._is_first = clause.verb == min(tops)
        inside = set(tree.subtree(self._top))
        for other in {top for top in tops.values() if top != self._top} & inside:
            inside -= tree.subtree(other)
        first = 1 if self._is_first else min(inside | {clause.verb})
        hidden = tree.abandoned | tree.quoted
        in_front = tree.words[first - 1 : clause.verb - 1]
        self._before = [word for word in in_front if word.index not in hidden]
        # "I'm thirsty, could you get me some water?" asks only at its end.
        later = min((verb for verb, top in tops.items() if verb > clause.verb and _asks(tree, top)), default=0)
        self._is_asked = any(
            word.form == "?" and not 0 < later < word.index
            for word in tree.words[clause.verb :]
            if word.index in inside and word.index not in hidden
        )
        self._has_aside = any(word.deprel == ASIDE and word.said not in _PADDING for word in in_front)
        self._said = self._formula_words()
        self._form = self._said[-1]

    def same_clause(self) -> int:
        """Return the verb above this one; 0 if there is none: "go" for "get" in "go to the kitchen to get the mug"."""
        above = (verb for verb, top in self._tops.items() if top == self._top and verb < self._clause.verb)
        return min(above, default=0)

    def joined_to(self) -> int:
        """Return the earlier verb that may share its subject and auxiliaries with this one; 0 if there is none."""
        top = self._tree.word(self._top)
        if top.deprel != "conj" or not top.head:
            return 0
        owner = _top(self._tree, top.head)
        return max((verb for verb, top in self._tops.items() if top == owner and verb < self._clause.verb), default=0)

    def is_renewed(self, before: KindVerdict) -> bool:
        """Whether a joined clause starts afresh: with a subject, an auxiliary, "so" or "but", or as a command that
        cannot be part of the statement before it ("I'm tired and bring me water").
        """
        children = self._tree.children(self._top)
        if any(word.deprel.startswith(("nsubj", "aux")) for word in children):
            return True
        in_front = {child.said for child in children if child.index < self._clause.verb}
        if in_front & RENEWING or (self._before and self._before[0].said in RENEWING):
            return True
        is_telling = before.kind in (UtteranceKind.REPORT, UtteranceKind.TALK)
        return self._form == "BASE" and is_telling and before.words.split(" ")[-1] in _FINISHED

    def is_watched(self) -> bool:
        """Whether the verb describes what somebody else does: "watch me *turn left*"."""
        top = self._tree.word(self._top)
        before = self._tree.word(self._verb.index - 1) if self._verb.index > 1 else self._verb
        is_object = before.head == top.head and before.deprel in ("obj", "iobj") and before.upos in ("PRON", "PROPN")
        return bool(top.head) and self._tree.governor(top).lemma.lower() in _WATCHING and is_object

    def verdict(self) -> KindVerdict:
        """Decide the kind by the words before the verb."""
        verdict = self._kind()
        if verdict.kind is UtteranceKind.COMMAND and self._has_aside:
            verdict = replace(verdict, kind=UtteranceKind.REQUEST, reason="request_formula")
        has_subject = bool(frozenset(self._said) & (_SUBJECTS | {"NP"}))
        is_told = verdict.kind in (UtteranceKind.REPORT, UtteranceKind.WISH, UtteranceKind.TALK)
        subject = self._tree.subject(self._top)
        # "*Whoever comes in*, greet them" says when.
        is_relative = subject is not None and subject.xpos == "WP"
        return replace(verdict, is_background=has_subject and is_told and not is_relative)

    def _kind(self) -> KindVerdict:
        if self.is_watched():
            return KindVerdict(UtteranceKind.REPORT, "complement", self._form)
        said = self._said
        start = next((number for number, text in enumerate(said) if _is_decisive(text)), None)
        if start is None:
            return self._without_subject()
        following = said[start + 1] if start + 1 < len(said) else ""
        if said[start] in _SUBORDINATING - {"why"} and following not in _AUXILIARIES | _BE | {"BE", "PAST"}:
            # "Where the counter is" describes a place; "where is the counter" asks.
            return KindVerdict(UtteranceKind.REPORT, "subordinate_clause", " ".join(said))
        # "Is not the window closed" asks; "the window is not closed" does not.
        is_inverted = following in _SUBJECTS or (following == "not" and "NP" not in said[:start])
        is_statement = "NP" in said[:start] and said[start] in _AUXILIARIES | _BE and not is_inverted
        return self._by_rules((["NP"] if is_statement else []) + said[start:])

    def _by_rules(self, said: Sequence[str]) -> KindVerdict:
        """Decide by the rules of the file; for "be", decide by subject and predicate."""
        text, subject = " ".join(said), said[0]
        acting = _rule(shipped_moods().acting, text)
        if acting is not None:
            return KindVerdict(acting.kind, acting.name, text)
        if subject in _MODALS and said[1:3] == ["not", "you"]:
            # "Can't you turn left?" asks; "can you not turn left" forbids.
            return KindVerdict(UtteranceKind.QUESTION, "negated_question", text)
        is_negated = "not" in said or subject == "nobody"
        affirmed = _rule(shipped_moods().acting, " ".join(word for word in said if word != "not"))
        if "not" in said and affirmed is not None:
            return KindVerdict(UtteranceKind.PROHIBITION, affirmed.name, text)
        rule = _rule(shipped_moods().telling, text)
        if rule is not None and rule.kind is UtteranceKind.QUESTION:
            return KindVerdict(rule.kind, rule.name, text)
        if self._is_asked:
            return KindVerdict(UtteranceKind.QUESTION, "question_mark", text)
        if is_negated and "you" in said and self._form in ("BASE", "GERUND"):
            return KindVerdict(UtteranceKind.PROHIBITION, "negated_duty", text)
        if self._form == "BE":
            return self._state(subject, said)
        if subject in _SPEAKERS and (self._verb.lemma.lower() in _OPINION_VERBS or self._verb.upos == "AUX"):
            return KindVerdict(UtteranceKind.TALK, "opinion", text)
        if rule is None or (rule.is_fact and self._form == "BASE" and self._verb.xpos != "VBP"):
            # "Bob turn left" is not a fact.
            return KindVerdict(UtteranceKind.REPORT, "statement", text)
        return KindVerdict(rule.kind, rule.name, text, is_fact=rule.is_fact)

    def _state(self, subject: str, said: Sequence[str]) -> KindVerdict:
        """Decide the kind of a clause with "be": the place or type of a thing is a fact, and a feeling is talk."""
        text = " ".join(said)
        predicate = self._tree.word(self._top) if self._verb.deprel == "cop" else self._verb
        children = self._tree.children(predicate.index)
        relations = {child.deprel.split(":")[0] for child in children}
        is_place = predicate.said in _PLACE_ADVERBS or "case" in relations
        # Who somebody is says something; how they are is talk.
        is_person = subject in _PERSONS and not (subject in _SPEAKERS and predicate.upos == "PROPN")
        is_opinion = subject in _OPINION_SUBJECTS and predicate.said in _CHATTER
        if is_opinion or (is_person and (not is_place or is_abstract(self._tree, predicate.index, is_mostly=True))):
            return KindVerdict(UtteranceKind.TALK, "state", text)
        is_noun = predicate.upos in NOUNS and "csubj" not in relations
        has_clause = bool(relations & {"xcomp", "ccomp", "csubj", "advcl"})
        is_for_something = is_place and any(child.deprel == "acl" for child in children)
        is_verb = predicate.upos == "VERB" and self._verb.deprel == "cop"
        is_event = frozenset(said[:-1]) & (_AUXILIARIES | _BE | _NONFINITE_BE | {"not"}) or self._is_done(predicate)
        is_event = bool(is_event) or any(child.said == "being" for child in children)
        # "The mug was on the table" does not say where it is.
        is_past = self._verb.xpos == "VBD"
        is_fact = not (is_for_something or (has_clause and not is_noun) or is_verb or is_event or is_past)
        return KindVerdict(UtteranceKind.REPORT, "fact" if is_fact else "statement", text, is_fact=is_fact)

    def _is_done(self, predicate: Word) -> bool:
        """Whether a predicate says what was done to a thing: "closed", "put on the table"."""
        form = predicate.said
        stems = (form[:-1], form[:-2], form[:-3], form[:-3] + "y") if form.endswith("ed") else ()
        is_participle = predicate.xpos in ("VBN", "VBG")
        return is_participle or any(self._vocabulary.verbs_beginning_with(stem) for stem in stems if stem)

    def _without_subject(self) -> KindVerdict:
        """Decide the kind of a clause without a pronoun, an auxiliary or a question word before its verb."""
        said, form = self._said, self._form
        text = " ".join(said)
        is_inverted = form == "BE" and not frozenset(said) & ({"NP"} | _SHOWN)
        is_asked = is_inverted and (self._is_first or self._clause.subject > self._clause.verb)
        # "Did the door open", if the parser takes "did" for the verb.
        if is_asked or (self._is_first and said == [form] and self._is_finite_auxiliary()):
            return KindVerdict(UtteranceKind.QUESTION, "inversion", text)
        if "not" in said and form in ("BASE", "GERUND"):
            return KindVerdict(UtteranceKind.PROHIBITION, "negated", text)
        if said[0] == "let" and len(said) > 1 and said[1] != "us":
            return KindVerdict(UtteranceKind.WISH, "let_me", text)
        if form == "GERUND":
            return self._gerund(text)
        subject = self._clause.subject
        is_spoken_to = not subject or self._tree.word(subject).said in _HEARERS or subject > self._clause.verb
        if form == "BASE" and is_spoken_to:
            is_infinitive = text.endswith(" to BASE") and _rule(shipped_moods().acting, text) is None
            if is_infinitive or (said[0] == "to" and self._verb.head > self._verb.index):
                return KindVerdict(UtteranceKind.TALK, "infinitive", text)
            return KindVerdict(UtteranceKind.COMMAND, "imperative", text)
        if form == "WISH" and (not subject or self._tree.word(subject).upos not in NOUNS):
            return KindVerdict(UtteranceKind.REQUEST, "wish_for_thing", text)
        if form == "WISH":
            # "The guests need plates": it is not the speaker who wants them.
            said = [*said[:-1], "BASE"]
        start = said.index("NP") if "NP" in said else len(said) - 1
        return self._by_rules(said[start:])

    def _is_finite_auxiliary(self) -> bool:
        return self._verb.said in _AUXILIARIES and self._form in ("PAST", "THIRD")

    def _gerund(self, text: str) -> KindVerdict:
        if self._verb.head > self._verb.index:
            return KindVerdict(UtteranceKind.REPORT, "gerund_subject", text)
        if text == "mind GERUND" or (self._has_aside and text == "GERUND"):
            return KindVerdict(UtteranceKind.REQUEST, "minding", text)
        if text == "GERUND":
            return KindVerdict(UtteranceKind.REPORT, "gerund_alone", text)
        return KindVerdict(UtteranceKind.TALK, "gerund", text)

    def _formula_words(self) -> List[str]:
        """Return the formula words before the verb, and the form of the verb."""
        skipped = self._subordinate()
        form = self._verb_form()
        said: List[str] = []
        for word in self._before:
            if word.index in skipped or word.upos == "PUNCT" or is_filler(word.form):
                continue
            text = _formula_word(word)
            if said and said[-1] in _AUXILIARIES and word.upos in NOUNS:
                # A hearer adds nothing; anybody else is a subject: "can Bob open the door".
                text = "" if word.said in _HEARERS else "NP"
            if said[-1:] == ["PREP"] and form == "BASE" and text in _OPINION_SUBJECTS:
                continue  # "After that turn left": with "that" as its subject, the verb would be "turns".
            if text and (text != "NP" or said[-1:] != ["NP"]):
                said.append(text)
        return [*said, form]

    def _subordinate(self) -> FrozenSet[int]:
        """Return the words of conditions and relative clauses that end before the verb."""
        found: FrozenSet[int] = frozenset()
        for word in self._before:
            relation = word.deprel.split(":")[0]
            inside = self._tree.subtree(word.index)
            if relation in ("advcl", "acl") and self._verb.index not in inside:
                marks = {child.said for child in self._tree.children(word.index)}
                found |= inside if relation == "acl" or marks & _CONDITIONS else frozenset()
        return found

    def _verb_form(self) -> str:
        word, form, lemma = self._verb, self._verb.said, self._verb.lemma.lower()
        if lemma == "be":
            is_helped = any(other.upos == "AUX" for other in self._before)
            return "BASE" if form == "be" and not is_helped else "BE"
        if form == lemma:
            if lemma in _WANTING:
                return "WISH"
            is_helped = any(child.deprel.startswith("aux") for child in self._tree.children(word.index))
            if word.xpos == "VBN" and (is_helped or word.deprel == "xcomp"):
                return "PART"
            return "PAST" if word.xpos == "VBD" and self._clause.subject else "BASE"
        is_helped = any(child.deprel.startswith("aux") for child in self._tree.children(word.index))
        if self._clause.subject and word.xpos in ("VB", "VBP") and not is_helped:
            return "PAST"  # "You forgot the sugar": the tagger takes it for a base form.
        by_ending = "GERUND" if form.endswith("ing") else "PAST" if form.endswith("ed") else "BASE"
        return _FORM_OF_TAG.get(word.xpos, by_ending)


def _asks(tree: DependencyTree, top: int) -> bool:
    """Whether a part that is joined to another part has an auxiliary before a subject of its own: "could you ..."."""
    children = tree.children(top) if tree.word(top).head else ()
    subject = next((child.index for child in children if child.deprel.startswith("nsubj")), 0)
    return any(child.upos == "AUX" and child.index < subject for child in children)


def _is_decisive(text: str) -> bool:
    """Whether a formula word shows that the words before a verb are more than a command."""
    return text in _SUBJECTS or text in _AUXILIARIES or text in _BE or text in _QUESTION_WORDS


def _rule(rules: Sequence[MoodRule], text: str) -> Optional[MoodRule]:
    return next((rule for rule in rules if rule.pattern.fullmatch(text)), None)


def _formula_word(word: Word) -> str:
    """Return the formula word for a word; empty if formulas ignore it."""
    form = word.said
    said = shipped_moods().spellings.get(form, form)
    if word.deprel == "vocative" and said not in _SUBJECTS:
        return ""
    if said in _NEGATING and word.upos != "INTJ":
        return "not"
    if said in _HABITUAL:
        return "habit"
    if form in _SAID_AROUND or word.upos in ("INTJ", "CCONJ", "SYM"):
        return ""
    if said == "'s":
        return "is" if word.upos in VERBS else "" if word.upos == "PART" else "us"
    if said in _QUESTION_WORDS | _OBJECTS | _SHOWN or (word.upos == "ADV" and said in shipped_moods().words):
        return said
    if said in _SUBJECTS:
        return "NP" if word.deprel in ("det", "obj") else said
    is_verb = word.upos in VERBS or word.xpos == "MD"
    if is_verb and said in _AUXILIARIES | _BE | _NONFINITE_BE:
        return said
    if word.upos == "ADV":
        return ""
    if word.upos in ("ADP", "SCONJ", "PART"):
        return said if said in shipped_moods().words else "PREP"
    if word.upos == "VERB":
        lemma = word.lemma.lower()
        return lemma + (_SUFFIX_OF_TAG.get(word.xpos, "") if form != lemma else "")
    return said if word.upos == "ADJ" and word.deprel != "amod" else "NP"


def _top(tree: DependencyTree, index: int) -> int:
    """Return the top word above a word: the root, or the head of the joined part that contains the word."""
    word = tree.word(index)
    while word.head and word.deprel.split(":")[0] not in ("conj", "parataxis", "list"):
        word = tree.governor(word)
    return word.index


def _tops(tree: DependencyTree, clauses: Sequence[Clause]) -> Dict[int, int]:
    """Return the top of each clause by its verb. A verb that is joined to a verb outside all clauses belongs to the
    part of that verb: "we are going to go ahead and look".
    """
    tops = {clause.verb: _top(tree, clause.verb) for clause in clauses}
    for verb, top in list(tops.items()):
        word = tree.word(top)
        while word.deprel == "conj" and _top(tree, word.head) not in tops.values():
            word = tree.word(_top(tree, word.head))
        tops[verb] = word.index
    return tops
