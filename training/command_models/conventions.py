"""One analysis for one thing: what hangs on what in generated trees, by the words alone and never by a draw.

The frames draw phrases; where a phrase may hang on two words, these rules decide. A place at which something is hangs
on its noun; where something goes, or is looked for, hangs on the verb, and which of the two it is depends on the verb,
on a receiver and on a further goal. The rest are conventions of UD_English-EWT, with its counts where they decide.
"""

from dataclasses import replace
from typing import List, Optional, Tuple

from .lexicon import EVALUATION, TRAINING
from .trees import Node

_STATIC = frozenset(
    """on in near by next_to under behind beside at above inside below against outside underneath beneath among
    close_to""".split()
)
_GOAL = _STATIC | frozenset("to into onto towards toward over_to back_to".split())
_PLACING = frozenset(
    """put place set leave drop hang lay stack pile heap store load stick insert pour release throw toss position rest
    deposit stow lean keep discard dump bin decant ladle park""".split()
)
_CARRYING = frozenset(
    "bring carry move deliver drag return push send transport transfer convey haul slide slip nudge shove".split()
)
_SEARCHING = frozenset("find search locate look seek hunt spot discover detect localize pinpoint".split())
#: Verbs that take the place of one preposition.
_TAKE = {
    "in": frozenset("boil simmer fry saute mix stir blend whisk combine wash rinse cook heat warm bake roast".split()),
    "on": frozenset(
        """attach connect fasten fix hook plug tie bind join link affix strap play perform sing report inform notify
        brief update alert warn""".split()
    ),
    "by": frozenset(
        """sort separate divide enter reach exit grasp grip clutch clasp seize squeeze hold lift heave brighten decrease
        reduce diminish dim darken increase boost lower raise hoist""".split()
    ),
    "against": frozenset("pull tug hurl fling".split()),
}
_TIMES = frozenset(
    """second minute hour day week month morning evening afternoon night noon midnight lunchtime half quarter o'clock
    time moment while monday tuesday wednesday thursday friday saturday sunday degree radian metre meter foot centimetre
    centimeter cm m inch step yard millimetre mm km mile ft decimetre distance couple percent bit""".split()
)
#: In EWT the person is their indirect object, also where nothing else is told: tell 134 of 138, ask 44 of 51,
#: inform, remind, warn and notify all.
TELLING = frozenset("tell ask inform remind warn notify".split())
_PERSONS = frozenset(TRAINING.people + EVALUATION.people)
_PERSONAL = frozenset("me him her us them you everyone everybody someone somebody anyone anybody nobody".split())
_MOVING = frozenset(
    """go come walk move run get leave bring drive fly climb sit lie head step ride travel proceed march stroll crawl
    sneak swim roll jump hop back look carry drag push pull send drop lower raise lift slide tilt push navigate return
    scoot creep rush hurry continue shift bend tip fall""".split()
)
#: Verbs of motion without an object: of "go down the hall", "down" is the preposition (in EWT 27 of 34).
_GOING = frozenset(
    """go come walk run travel proceed head drive climb march stroll crawl sneak continue creep scoot hurry rush
    navigate return ride step swim fly advance""".split()
)
#: Where EWT has a particle in spite of the verb's moving, or an adverb in spite of its staying.
_PARTICLE_OF = frozenset(
    (
        *(("back", "up"), ("look", "up"), ("step", "up"), ("lift", "up"), ("get", "up"), ("lift", "off")),
        *(("drop", "off"), ("pull", "off"), ("carry", "out"), ("look", "over"), ("look", "out"), ("move", "on")),
        *(("go", "on"), ("come", "on"), ("pull", "out"), ("take", "over"), ("hand", "over"), ("lift", "out")),
    )
)
_AMBIGUOUS_STATES = frozenset("close lock open shut".split())


def case_of(node: Node) -> str:
    """Return the preposition of a phrase: "on", "next_to"; empty if it has none."""
    return "_".join(child.form.lower() for child in node.left if child.rel == "case" and child.xpos != "POS")


def takes_place(verb: str, preposition: str) -> bool:
    """Whether a place behind the verb's object is where it goes or is looked for, and hangs on the verb."""
    return verb in _PLACING or verb in _CARRYING or verb in _SEARCHING or verb in _TAKE.get(preposition, ())


def particle_relation(verb: str, form: str) -> str:
    """Return what a bare "up", "out", "back" is to its verb: the majority of EWT for each pair, else for its word."""
    if form in ("back", "away", "around", "along"):
        return "advmod"
    if (verb, form) in _PARTICLE_OF:
        return "compound:prt"
    return "advmod" if verb in _MOVING and form in ("up", "down", "out", "over", "off", "in") else "compound:prt"


_PARTICLES = frozenset("up down out over off on in".split())


def settled(node: Node) -> Node:
    """Return a tree with the conventions in all of it."""
    node = replace(
        node, left=tuple(settled(child) for child in node.left), right=tuple(settled(child) for child in node.right)
    )
    if node.upos == "VERB":
        node = _predicating(_told(_particles(node)))
        if not node.has("expl"):
            node = replace(node, right=_placed(node))
    return node


def _is_place(node: Node) -> bool:
    return case_of(node) in _STATIC and node.upos == "NOUN" and node.lemma.lower() not in _TIMES


def _placed(verb: Node) -> Tuple[Node, ...]:
    """Return the right dependants of a verb, each place on its noun or on the verb."""
    found: List[Node] = []
    receiver = verb.has("iobj")
    waiting = list(verb.right)
    while waiting:
        child = waiting.pop(0)
        before = found[-1] if found else None
        if child.rel == "obl" and before is not None and _is_place(child) and _hangs_on_noun(verb, before, child):
            found[-1] = _hung(before, child)
            continue
        if _sought(verb, child) or (child.rel == "obj" and child.right and not _goal_follows(waiting)):
            last = child.right[-1] if child.right else None
            if last is not None and last.rel == "nmod" and _is_place(last) and child.upos == "NOUN":
                searching = verb.lemma in _SEARCHING
                if takes_place(verb.lemma, case_of(last)) and (searching or not receiver):
                    found += [replace(child, right=child.right[:-1]), replace(last, rel="obl")]
                    continue
        found.append(child)
    return tuple(found)


def _sought(verb: Node, child: Node) -> bool:
    return verb.lemma in _SEARCHING and child.rel == "obl" and case_of(child) == "for"


def _goal_follows(siblings: List[Node]) -> bool:
    return bool(siblings) and siblings[0].rel == "obl" and case_of(siblings[0]) in _GOAL and _no_time(siblings[0])


def _no_time(node: Node) -> bool:
    return node.upos in ("NOUN", "PROPN", "PRON") and node.lemma.lower() not in _TIMES


def _hangs_on_noun(verb: Node, before: Node, place: Node) -> bool:
    """Whether a place behind another phrase is said of its noun."""
    if before.upos != "NOUN" or before.lemma.lower() in _TIMES or _end(before) is None:
        return False
    if before.rel == "obl":
        return bool(case_of(before)) and not _sought(verb, before) and not before.has("conj")
    if before.rel != "obj" or before.has("conj"):
        return False
    preposition = case_of(place)
    if verb.lemma in _SEARCHING:
        return False
    return not takes_place(verb.lemma, preposition) or (verb.has("iobj") and preposition != "by")


def _end(node: Node) -> Optional[Node]:
    """Return the noun at the end of a phrase, on which a place behind it hangs; None if its end is another thing."""
    if not node.right:
        return node if node.upos == "NOUN" else None
    last = node.right[-1]
    return _end(last) if last.rel == "nmod" and last.upos == "NOUN" and case_of(last) != "of" else None


def _hung(node: Node, place: Node) -> Node:
    """Hang a place on the noun at the end of a phrase."""
    if not node.right:
        return node.post("nmod", place)
    return replace(node, right=(*node.right[:-1], _hung(node.right[-1], place)))


def _particles(verb: Node) -> Node:
    right: List[Node] = []
    for child in verb.right:
        bare = not child.left and not child.right
        previous = right[-1] if right else None
        if child.rel == "obj" and child.upos == "NOUN" and previous is not None and verb.lemma in _GOING:
            if previous.form in _PARTICLES and not previous.left and not previous.right:
                way = replace(previous, upos="ADP", xpos="IN")
                right[-1] = replace(child.pre("case", way), rel="obl")
                continue
        if bare and child.form in ("there", "here") and child.rel == "advmod" and previous is not None:
            if previous.form in _PARTICLES | {"back"} and not previous.left and not previous.right:
                # "over there" is one place.
                right[-1] = child.pre("advmod", replace(previous, upos="ADV", xpos="RB"))
                continue
        if bare and child.form in _PARTICLES and child.rel in ("compound:prt", "advmod"):
            relation = particle_relation(verb.lemma, child.form)
            child = replace(child, rel=relation, upos="ADV", xpos="RB") if relation == "advmod" else child
            child = replace(child, rel=relation, upos="ADP", xpos="RP") if relation != "advmod" else child
        right.append(child)
    return replace(verb, right=tuple(right))


def _person(node: Node) -> bool:
    return node.upos == "PROPN" or node.form.lower() in _PERSONAL or node.lemma in _PERSONS


def _told(verb: Node) -> Node:
    if verb.lemma not in TELLING or verb.has("iobj"):
        return verb
    right = tuple(
        replace(child, rel="iobj") if child.rel == "obj" and _person(child) else child for child in verb.right
    )
    return replace(verb, right=right)


def _predicating(verb: Node) -> Node:
    """Of "my task is to clean", the subject stands outside of the clause: 52 of 53 in EWT."""
    if not any(child.rel == "cop" for child in verb.left):
        return verb
    left = tuple(replace(child, rel="nsubj:outer") if child.rel == "nsubj" else child for child in verb.left)
    return replace(verb, left=left)


def unclear(node: Node) -> bool:
    """Whether the words leave open what is meant: such a sentence teaches nothing but chance."""
    if any(unclear(child) for child in node.left + node.right):
        return True
    if node.upos != "VERB":
        return _unclear_list(node)
    if node.rel == "acl" and node.xpos == "VBN" and not node.right:
        return True  # "the mug walked"
    if any(child.rel == "aux:pass" for child in node.left) and not node.has("obl:agent"):
        # "is locked" is a state as well
        if (node.lemma in _AMBIGUOUS_STATES or node.lemma.startswith("un")) and not node.right:
            return True
    for child, follower in zip(node.right, node.right[1:]):
        if child.rel == "obj" and follower.form in _PARTICLES and node.lemma in _GOING:
            return True  # "come the box down"
        if follower.rel not in ("obl", "advmod", "obl:unmarked", "compound:prt"):
            continue
        if _ends_in_clause(child):
            return True  # "bring the mug you found on the table"
        if child.rel == "obj" and child.has("conj") and _is_place(follower):
            if not takes_place(node.lemma, case_of(follower)):
                return True  # "take the mug and the plate on the table"
    return any(
        child.rel == "obj" and not _person(child) and child.right and case_of(child.right[-1]) in ("with", "for")
        for child in node.right
    )


def _ends_in_clause(node: Node) -> bool:
    if not node.right:
        return False
    last = node.right[-1]
    return (last.rel in ("acl:relcl", "acl") and last.upos == "VERB") or _ends_in_clause(last)


def _unclear_list(node: Node) -> bool:
    """Whether a list runs on without a mark and its next noun has no determiner: "the kitchen office"."""
    for child in node.right:
        if child.rel == "conj" and child.upos == "NOUN":
            if not any(one.rel in ("cc", "det", "nmod:poss", "nummod", "case", "amod") for one in child.left):
                return True
    return False
