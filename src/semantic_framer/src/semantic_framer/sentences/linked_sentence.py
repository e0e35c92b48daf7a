"""Understands a sentence whose deeds are joined by conditions and times: "wait until Anna comes, then greet her"."""

from dataclasses import replace
from typing import Optional, Sequence, Tuple, Union

from semantic_framer.asking.choices import choices_left_open
from semantic_framer.asking.settling import Now, resolve_and_confirm, without_positions
from semantic_framer.clauses.deeds import deeds_of, words_told
from semantic_framer.clauses.found_clauses import found_clauses
from semantic_framer.clauses.readings import Heard
from semantic_framer.judging.said_words import positions_named
from semantic_framer.judging.verdicts import case_of
from semantic_framer.linking.clause_links import condition_places, find_joints
from semantic_framer.linking.joints import Joints, may_be_of_last_choice
from semantic_framer.linking.link_file import LinkKind, shipped_links
from semantic_framer.linking.link_words import MANY_PERSONS
from semantic_framer.linking.linked_clauses import WAITING, NoStructure, Open, ends_what_runs, which_of_it
from semantic_framer.linking.linked_plan import linked_plan
from semantic_framer.linking.named_persons import asked_of_hearer, with_persons
from semantic_framer.linking.news import with_news
from semantic_framer.linking.standing_plan import with_wait
from semantic_framer.referring.persons_spoken_of import PERSONAL_PRONOUNS
from semantic_framer.units.frame_roles import MESSAGE
from semantic_framer.units.framed_lexicon import FramedLexicon
from semantic_framer.values.clause_plan import Clauses, PlanPart, answers_in_a_loop, leaves_of, without_unused
from semantic_framer.values.dialogue import Context, Pending
from semantic_framer.values.order_words import FIRST, LAST
from semantic_framer.values.outcome import QUESTION, REPORT, TALK, Question, Refusal, Understood
from semantic_framer.values.reading import Reading
from semantic_framer.values.sentence import Sentence
from typed_arguments import TimeExpression
from utterance_passes.phrases.clauses import find_clauses
from utterance_passes.phrases.clock_times import clock_time_at
from utterance_passes.trees.tree import ASIDE, QUOTATION_MARKS, QUOTED, VERBS, DependencyTree, Word
from utterance_passes.trees.tree_edits import NotATree, TreeEdit, mark_times, set_aside
from word_classes import word_class

#: Codes of refusals of the deeds that say more than that the sentence has a condition.
_TELLING = frozenset(["UNKNOWN_VERB", "UNKNOWN_FRAME", "NO_READING", "LEFT_OVER_WORDS"])
#: What is no part of a thing or place: "the hall and the office *in any order*".
_MANNERS = (
    LinkKind.ANY_ORDER,
    LinkKind.IN_ORDER,
    LinkKind.BEFORE_THAT,
    LinkKind.ROUND,
    LinkKind.REVERSED,
    LinkKind.ALTERNATING,
    LinkKind.RETURNING,
    LinkKind.FOREVER,
    LinkKind.AT_A_TIME,
    LinkKind.TIMES,
    LinkKind.AT_LEAST,
    LinkKind.AT_MOST,
)
#: What takes a standing order back. Behind it, a time says which order is meant: "forget the alarm at seven".
_BACK = ("forget", "cancel")
_FINITE = frozenset(["VBZ", "VBP", "VBD"])
_OTHERWISE = (LinkKind.OTHERWISE, LinkKind.OR_ELSE)
_EACH, _HEARERS = frozenset(["every", "each"]), word_class("hearers")
_WHO = word_class("relative_pronouns")
_DOWNWARD = word_class("verb_particles")
_LASTING = word_class("lasting_verbs")
#: Relations of a verb that depends on the one before it.
_DONE = frozenset(["having"])
_OF_TIMES = frozenset(["advmod", "obl:unmarked"])
_DEPENDENT = frozenset(["advcl", "xcomp", "ccomp", "acl", "dep"])


def understand_linked(
    sentence: Sentence, context: Context, now: Now, before: Union[Refusal, Question], joints: Joints
) -> Optional[Heard]:
    """Understand a sentence whose deeds are joined by conditions and times; None if it is none.

    Args:
        sentence: the sentence
        context: what the framer remembers of earlier utterances
        now: the circumstances of the utterance
        before: why the sentence cannot be understood as it is
        joints: what joins its deeds
    """
    unknown = _unknown_link(sentence, joints, before)
    if isinstance(unknown, Question) and joints.open_time is None:
        pending = Pending((), 0, (), now.expires_s, unfinished=sentence.tree)
        return Heard(unknown, replace(context, pending=pending), sentence)
    refused = Heard(unknown, context, sentence) if unknown is not None else None
    if refused is not None and joints.open_time is not None:
        return _with_open_time(sentence, now, before, joints, refused)
    if not joints.found:
        return refused
    try:
        left = _without_joints(sentence, joints, now.known)
    except NotATree:
        return None
    if left is None:
        question = Question("MISSING_ELEMENT", f"What should I do {joint_words(sentence, joints)}?")
        return None if before.code in (QUESTION, TALK) else Heard(question, context, sentence)
    for joint in joints.found:
        now.write("links", sentence.text(sorted(joint.positions)), joint.kind.value)
    bare = Sentence(left, now.known.types, unquoted_tree=sentence.unquoted_tree)
    parts = found_clauses(bare, find_clauses(left, now.known), now.known, now.trace)
    case = case_of(bare, parts, now.known, now.policy)
    refusal, clauses = deeds_of(case, now.trace)
    waiting = positions_named(
        reading
        for read in clauses
        for reading in read.kept
        if now.known.frames[reading.unit.frame_name].framenet == WAITING
    )
    if refusal is not None:
        return Heard(refusal, context, sentence) if refusal.code in _TELLING and refused is None else refused
    clauses = tuple(replace(read, kept=_deeds_first(read.kept, now)) for read in clauses)
    is_open = choices_left_open(bare, [(read.clause, read.kept[0]) for read in clauses], now.known)
    names_an_order = any(joint.when for joint in joints.found) and any(read.clause.lemma in _BACK for read in clauses)
    if is_open or names_an_order or not all(case.kind_of(read.clause).acts for read in clauses):
        return refused
    try:
        deeds = [(read.clause, read.kept) for read in clauses]
        kept, plan = without_unused(*linked_plan(sentence, now.known, deeds, joints.found))
        kept = with_news(with_persons(kept, bare, now.known.frames, context.persons), sentence, joints, now.known)
        if answers_in_a_loop(plan, kept, now.known.frames):
            raise NoStructure("what is answered at once does not go on")
        if may_be_of_last_choice(sentence.tree, joints.found):
            raise NoStructure("the condition may be that of the last choice alone")
    except Open as question_of:
        return Heard(Question("AMBIGUOUS", str(question_of)), context, sentence)
    except NoStructure as reason:
        now.write("links", sentence.tree.text, f"refused. {reason}")
        return refused
    now.write("plan", sentence.tree.text, str(plan))
    deeds_said = [kept[leaf.clause] for leaf in leaves_of(plan) if leaf.kind == "DO"]
    is_stop = bool(deeds_said) and all(ends_what_runs(readings, now.known) for readings in deeds_said)
    plan = with_wait(plan) if is_stop else plan
    outcome, after = resolve_and_confirm(kept, bare, context, now, plan=plan)
    if is_stop and isinstance(outcome, Understood) and plan.kind not in ("AT", "WHENEVER"):
        # What is to be stopped runs until then.
        outcome = replace(outcome, beginning="BESIDE")
    if isinstance(outcome, Question) and after.pending is not None:
        outcome = _asked_of_condition(sentence, joints, kept, after.pending, outcome)
    whose = asked_of_hearer(sentence, joints, kept, now.known) if isinstance(outcome, Understood) else None
    if whose is not None:
        return Heard(whose, context, sentence, clauses)
    doubt = _asked_first(sentence, joints, plan) if isinstance(outcome, Understood) else None
    if doubt is not None:
        now.write("links", sentence.tree.text, f"asked. {doubt.sentence}")
        pending = Pending(without_positions(kept), 0, (), now.expires_s, plan=plan, is_about_words=True)
        outcome, after = doubt, replace(context, pending=pending)
    named = joints.positions.union(waiting, words_told(case, clauses), *(joint.items for joint in joints.found))
    return Heard(outcome, after, sentence, clauses, named=named)


def _asked_of_condition(
    sentence: Sentence, joints: Joints, clauses: Clauses, pending: Pending, asked: Question
) -> Question:
    """Return a question what a pronoun in a condition means: "If what is open?"."""
    name = pending.elements[0] if asked.code == "AMBIGUOUS" and pending.elements and not pending.offered else ""
    value = clauses[pending.clause][0].argument(name) if name else None
    if value is None or pending.choices:
        return asked
    joint = next((one for one in joints.found if one.condition and set(value.positions) <= one.positions), None)
    if joint is None or not value.positions:
        return asked
    what = "whom" if value.text.lower() in PERSONAL_PRONOUNS else "what"
    before = sentence.text([index for index in sorted(joint.positions) if index < min(value.positions)])
    behind = sentence.text([index for index in sorted(joint.positions) if index > max(value.positions)])
    space = "" if behind[:1] in ("'", "\u2019") else " "
    said = f"{before} {what}{space}{behind}".strip()
    return replace(asked, sentence=f"{said[0].upper()}{said[1:]}?")


def _with_open_time(
    sentence: Sentence, now: Now, before: Union[Refusal, Question], joints: Joints, refused: Heard
) -> Heard:
    """Ask for a time ("At what time tomorrow?"), and remember what is to be done then."""
    whole, words = _as_if_timed(sentence, joints)
    heard = understand_linked(sentence, refused.context, now, before, whole)
    if heard is None or not isinstance(heard.outcome, Understood) or heard.outcome.plan is None:
        return refused
    clauses = without_positions(heard.outcome.clauses)
    pending = Pending(clauses, 0, (), now.expires_s, plan=heard.outcome.plan, open_time=words)
    return replace(heard, outcome=refused.outcome, context=replace(heard.context, pending=pending))


def _deeds_first(readings: Tuple[Reading, ...], now: Now) -> Tuple[Reading, ...]:
    """Return the readings that act, if one does: "proceed until ..." is no answer to what waits."""
    frames = now.known.frames
    return tuple(reading for reading in readings if not frames[reading.unit.frame_name].is_question) or readings


def _without_joints(sentence: Sentence, joints: Joints, known: FramedLexicon) -> Optional[DependencyTree]:
    """Return the tree of a sentence with the words that join set aside; None if no other words are left.

    Raises:
        NotATree: the words that are left make no tree
    """
    tree = sentence.tree
    left = [word for word in tree.open_words if word.index not in joints.positions and word.upos != "PUNCT"]
    if not left:
        return None

    def is_verb(word: Word) -> bool:
        return word.upos == "VERB" or bool(known.verbs_beginning_with(word.lemma.lower()))

    # The times among the words that join are accounted for.
    times = tuple(time for time in tree.times if not time <= joints.positions)
    made = set_aside(_with_deeds_apart(_with_lists(tree, joints), joints), joints.positions, ASIDE, is_verb)
    return mark_times(made, times)


def _with_lists(tree: DependencyTree, joints: Joints) -> DependencyTree:
    """Make a list of two items whose order is said, or between which the robot goes: "the office *after* the hall",
    "*from* the office *to* the hall".
    """
    edit = TreeEdit(tree)
    for joint in joints.found:
        if len(joint.items) > 3:
            edit.respell(joint.items[3], "to")
        if joint.items:
            one, border, other = joint.items[:3]
            edit.respell(border, "and")
            edit.retag(border, "CCONJ", "CC")
            edit.rehang(border, other, "cc")
            edit.rehang(other, one, "conj")
    return edit.tree()


def _with_deeds_apart(tree: DependencyTree, joints: Joints) -> DependencyTree:
    """Let each deed that hangs on words that join stand beside the others: "if that fails *bring* me the cup"."""
    edit = TreeEdit(tree)
    joining = joints.positions
    deeds = frozenset(joint.verb for joint in joints.found if joint.verb)
    for word in tree.words:
        if word.index in deeds:
            # "After *closing* the door" and "before you *close* it" command what "close it" commands.
            is_been = word.deprel == "cop" and tree.word(word.index + 1).said == "to"
            lemma = "go" if is_been else word.lemma.lower()
            if is_been:
                # "After you have *been* to the hall": the place is the head.
                above = tree.governor(word).head
                edit.rehang(word.index, above, "parataxis" if above else "root")
                edit.rehang(word.head, word.index, "obl")
            edit.retag(word.index, "VERB", "VB")
            edit.respell(word.index, lemma, lemma)
            comma = next((one.index for one in tree.words[word.index :] if one.form == ","), len(tree.words))
            end = comma if word.head > word.index else len(tree.words)
            for other in tree.children(word.head) if word.deprel != "cop" else ():
                if word.index < other.index < end and other.deprel in _OF_TIMES:
                    edit.rehang(other.index, word.index)  # "Go to the hall after visiting the office *twice*."
        if word.index in joining or word.upos != "VERB" or word.deprel not in _DEPENDENT:
            continue
        marks = [child for child in tree.children(word.index) if child.index in joining and child.deprel == "mark"]
        if marks or word.head in joining or word.index in deeds:
            edit.relabel(word.index, "parataxis")
    return edit.tree()


def swallowed_joints(sentence: Sentence, known: FramedLexicon, readings: Sequence[Reading]) -> Joints:
    """Return the conditions at the end of arguments: "go to the kitchen *at the moment that Anna comes*".

    "Tell me if the door is open" asks for the condition itself, and a message may have a condition of its own.
    """
    inside = [argument for reading in readings for argument in reading.arguments if len(argument.positions) > 1]
    places = condition_places(sentence)
    if not any(min(one.positions) < place <= max(one.positions) for one in inside for place in places):
        return Joints()
    found = [
        joint
        for joint in find_joints(sentence, known).found
        if joint.condition is not None
        for argument in inside
        if min(argument.positions) < joint.first <= max(argument.positions) <= max(joint.positions)
        if not any(sentence.word(index).upos in VERBS for index in argument.positions if index < joint.first)
    ]
    return Joints(tuple(found))


def swallowed_words(sentence: Sentence, known: FramedLexicon, readings: Sequence[Reading]) -> str:
    """Return words that join and were taken for a part of an argument: "a glass, *otherwise a mug*"; empty for none."""
    for reading in readings:
        frame = known.frames[reading.unit.frame_name]
        for argument in reading.arguments:
            element = frame.element(argument.name)
            words = [sentence.word(index) for index in sorted(argument.positions)]
            forms = [word.said for word in words]
            if element is not None and element.framenet == MESSAGE:
                # "Tell everyone *who asks* that I am at lunch" is no message.
                before = sentence.word(words[0].index - 1).said if words and words[0].index > 1 else ""
                joiner, _ = shipped_links().joiner_at(forms)
                if joiner is not None and joiner.kind in _OTHERWISE:
                    return sentence.text([word.index for word in words])  # "Tell him, *if not, tell Anna*."
                if before in MANY_PERSONS and forms[0] in _WHO:
                    return sentence.text([word.index for word in words])
                continue
            for place in range(2, len(words)):
                is_person = _are_many(forms[:place]) and forms[place - 1] in _WHO
                if forms[place - 2] in MANY_PERSONS and forms[place - 1] in _HEARERS and words[place].upos == "VERB":
                    return sentence.text([word.index for word in words[place - 1 :]])  # "Everyone *you meet*."
                if is_person and (_is_deed(words[place]) or set(forms[place + 1 : place + 2]) & _DOWNWARD):
                    return sentence.text([word.index for word in words[place - 1 :]])
            for place in range(1, len(words)):
                if forms[place - 1] in MANY_PERSONS and words[place - 1].xpos == "WP" and _is_deed(words[place]):
                    return sentence.text([word.index for word in words[place - 1 :]])  # "*Whoever comes in*."
                joiner, _ = shipped_links().joiner_at(forms[place:])
                if joiner is not None and joiner.kind in _OTHERWISE:
                    return sentence.text([word.index for word in words[place:]])
    return ""


def _are_many(forms: Sequence[str]) -> bool:
    """Whether words before "who" mean each of many: "everybody who", "every guest who"."""
    return forms[-2] in MANY_PERSONS or (len(forms) > 2 and forms[-3] in _EACH)


def _is_deed(word: Word) -> bool:
    """Whether somebody who does that does it now and then: "everyone who *sits* down", but not "who lives here"."""
    return word.upos == "VERB" and word.xpos in ("VBZ", "VBP") and word.lemma.lower() not in _LASTING


def has_lost_link(sentence: Sentence, readings: Sequence[Reading]) -> bool:
    """Whether a link before a thing was lost: "turn left *until* the bell rings", read as "turn the rings"; "see if it
    is open and *in that case* close it", read as "see if it is open and close it"."""
    if _answer_words(sentence):
        return True
    said = frozenset(index for reading in readings for argument in reading.arguments for index in argument.positions)
    marks = [word for word in sentence.tree.open_words if word.deprel == "mark" and word.index not in said]
    links = [shipped_links().link_at([word.said])[0] for word in marks if word.head in said]
    # "Check *if* the lights are off" asks; an end is no question.
    return any(link is not None and link.kind is LinkKind.UNTIL for link in links)


def _answer_words(sentence: Sentence) -> Tuple[int, ...]:
    """Return the positions of words that say in which case something is done: "*in that case* close it"."""
    words, links = sentence.tree.open_words, shipped_links()
    forms = [word.said for word in words]
    for place in range(len(forms)):
        length = links.case_at(forms[place:])
        if length:
            return tuple(word.index for word in words[place : place + length])
    return ()


def doubtful_message(sentence: Sentence, known: FramedLexicon, readings: Sequence[Reading]) -> Optional[Question]:
    """Return a question about a condition at the end of a message that has a verb of its own; None if there is none.

    "Say that dinner is ready when Bob comes home" may be said now, or when Bob comes home. In quotation marks it is a
    message.
    """
    for reading in readings:
        frame = known.frames[reading.unit.frame_name]
        for argument in reading.arguments:
            element = frame.element(argument.name)
            if element is None or element.framenet != MESSAGE or len(argument.positions) < 2:
                continue
            words = [sentence.word(index) for index in sorted(argument.positions)]
            place = _condition_behind(words) or _time_behind(sentence, words)
            if place and words[place].deprel == QUOTED and sentence.tree.governor(words[place]).deprel == "xcomp":
                continue  # "Tell Bob to wait until I come back": he waits, and it takes no time to tell him.
            if place and not _is_marked(sentence, words[-1].index):
                said = sentence.text([word.index for word in words[place:]]).strip(" ,.!?")
                return Question("AMBIGUOUS", which_of_it(said))
    return None


def _condition_behind(words: Sequence[Word]) -> int:
    """Return the place of a link before a verb: "dinner is ready *when* Bob comes", "hello *until* somebody answers";
    0 for none.
    """
    # The tagger may take a verb for a noun: "until someone answers".
    verbs = [place for place, word in enumerate(words) if word.upos in VERBS or word.deprel == "ccomp"]
    forms = [word.said for word in words]
    for place, word in enumerate(words):
        is_between = bool(verbs) and 0 < place < verbs[-1]
        is_link = word.upos == "SCONJ" or word.xpos == "WRB"
        if is_between and is_link and shipped_links().link_at(forms[place:])[1]:
            return place
    return 0


def _time_behind(sentence: Sentence, words: Sequence[Word]) -> int:
    """Return the place of a time at the end of a message without a verb: "good night *at ten pm*"; 0 for none."""
    if any(word.upos == "AUX" or word.xpos in _FINITE for word in words):
        return 0
    forms = [word.said for word in words]
    for place in range(1, len(words)):
        clock = clock_time_at(forms[place:])
        if clock is not None and clock.when is not None and place + clock.length == len(words):
            return place
    return 0


def _is_marked(sentence: Sentence, last: int) -> bool:
    """Whether the last word of a message stands in quotation marks."""
    behind = sentence.tree.words[last : last + 2]
    return any(word.form in QUOTATION_MARKS for word in behind)


def manners(sentence: Sentence, known: FramedLexicon) -> Joints:
    """Return what joins the deeds of a sentence that says in which order they are done, or how often; nothing for
    another sentence.
    """
    said = frozenset(word.said for word in sentence.tree.open_words)
    links = shipped_links()
    has_order = any(links.deed_link_at([form])[1] for form in said) or said & (FIRST | LAST)
    if not links.has_manner(said) and not has_order and not said & (MANY_PERSONS | _DONE):
        return Joints()
    joints = find_joints(sentence, known)
    is_meant = any(joint.kind in _MANNERS or joint.is_of_persons for joint in joints.found)
    # "*Having been* to the hall, go to the office" reports nothing, and "go *only after that*" follows nobody.
    is_meant = is_meant or any(joint.verb and sentence.word(joint.first).said in _DONE for joint in joints.found)
    is_meant = is_meant or any(joint.kind is LinkKind.THEN and "only" in joint.words.split() for joint in joints.found)
    return joints if is_meant else Joints()


def _asked_first(sentence: Sentence, joints: Joints, plan: PlanPart) -> Optional[Question]:
    """Return what a person is asked before a plan is carried out; None if nothing is doubtful.

    Args:
        sentence: the sentence
        joints: what joins its deeds
        plan: how they are joined
    """
    meanwhile = [joint for joint in joints.found if joint.kind is LinkKind.BEFOREHAND]
    if meanwhile:
        words = sentence.text(sorted(meanwhile[0].positions))
        text = f'I cannot do the "{words[:1].lower()}{words[1:]}" part. Shall I do the rest?'
        return Question("LEFT_OVER_WORDS", text)
    if any(joint.order is not None and joint.order.is_doubtful for joint in joints.found):
        labels = [leaf.label for leaf in leaves_of(plan)]
        deeds = ", then ".join([*labels[:1], *(f"{label[:1].lower()}{label[1:]}" for label in labels[1:])])
        return Question("CONFIRM", f'Shall I do this: "{deeds}"? Say yes or no.')
    return None


def _as_if_timed(sentence: Sentence, joints: Joints) -> Tuple[Joints, Tuple[str, ...]]:
    """Return the joints of a sentence as if its open time were known, and the words of that time in lower case."""
    time = joints.open_time
    if time is None:
        return joints, ()
    words = tuple(sentence.word(index).said for index in sorted(time.positions))
    known = replace(time, when=TimeExpression("time", " ".join(words), relation="at", value="T00:00"))
    return Joints(tuple(sorted((*joints.found, known), key=lambda joint: joint.first))), words


def joint_words(sentence: Sentence, joints: Joints) -> str:
    """Return the words that join, as a person would quote them."""
    words = sentence.text(sorted(joints.positions) or _answer_words(sentence)).strip(" ,.!?")
    return words[:1].lower() + words[1:]


def _unknown_link(
    sentence: Sentence, joints: Joints, before: Union[Refusal, Question]
) -> Optional[Union[Refusal, Question]]:
    """Return what to reply if nothing is understood behind a link: "until when?", or which condition it is.

    Args:
        sentence: the sentence
        joints: what joins its deeds
        before: why the sentence cannot be understood as it is
    """
    if before.code == REPORT and joints.unknown and _is_front(sentence, joints.unknown):
        before = replace(before, code="CONDITION")  # "Once the water boils, turn off the stove" reports nothing.
    if before.code not in ("CONDITION", "LEFT_OVER_WORDS"):
        return None
    if joints.question:
        return Question("MISSING_ELEMENT", joints.question)
    if not joints.unknown or before.code != "CONDITION":
        return None
    words = sentence.text(joints.unknown)
    return Refusal("CONDITION", f'I do not understand "{words}" as a condition, so I do nothing.')


def _is_front(sentence: Sentence, positions: Sequence[int]) -> bool:
    """Whether words begin a sentence, and a deed stands behind a mark: "once the water boils, *turn* off the stove"."""
    words = sentence.tree.open_words
    if not words or positions[0] != words[0].index:
        return False
    behind = next((place for place, word in enumerate(words) if word.form == ","), len(words)) + 1
    # A verb alone is easily taken for a noun: "while the music plays, *dance*".
    left = [word for word in words[behind:] if word.upos != "PUNCT"]
    return bool(left) and (len(left) == 1 or (left[0].upos == "VERB" and left[0].xpos in ("VB", "VBP")))
