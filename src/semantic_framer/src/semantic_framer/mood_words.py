"""The English words that tell the mood of a clause: one place, so that they can become a file of word classes."""

from typing import Dict, FrozenSet

#: What clitics and short spellings stand for, in the words that the formulas of :mod:`utterance_kind` are made of.
FULL_FORMS: Dict[str, str] = {
    "n't": "not",
    "nt": "not",
    "'m": "am",
    "'re": "are",
    "'ve": "have",
    "'ll": "will",
    "'d": "would",
    "ca": "can",
    "wo": "will",
    "sha": "shall",
    "u": "you",
    "ya": "you",
    "y'all": "you",
    "cannot": "can not",
}
SPEAKERS: FrozenSet[str] = frozenset(["i", "we"])
ADDRESSEES: FrozenSet[str] = frozenset(["you"])
#: Pronouns that only a subject is said with, and those that stand for a subject where they stand before a verb.
SUBJECT_PRONOUNS: FrozenSet[str] = (
    frozenset(
        "he she they it this that these those there who whoever someone somebody anyone anybody everyone everybody nobody "
        "something anything everything nothing".split()
    )
    | SPEAKERS
    | ADDRESSEES
)
#: Persons: what is said of them with an adjective is talk.
PERSONAL_PRONOUNS: FrozenSet[str] = frozenset(
    "i we you he she someone somebody everyone everybody nobody".split()
)
BE: FrozenSet[str] = frozenset("am is are was were be been being 's".split())
HAVE: FrozenSet[str] = frozenset(["have", "has", "had"])
DO: FrozenSet[str] = frozenset(["do", "does", "did"])
MODALS: FrozenSet[str] = frozenset("can could will would shall should may might must".split())
QUESTION_WORDS: FrozenSet[str] = frozenset("who whom whose what which how why where when".split())
#: They join a clause as well as they ask: "when I say so".
SUBORDINATING: FrozenSet[str] = frozenset(["when", "where"])
#: Subordinators of clauses that say under which condition, when or why.
SUBORDINATORS: FrozenSet[str] = frozenset(
    "if when while after before because since until till unless once whenever although though as".split()
)
#: How often or whether something happens: who says so tells or asks a habit, or doubts it.
HABITUAL: FrozenSet[str] = frozenset("ever often always usually sometimes already still even really normally rarely seldom generally".split())
NEGATING: FrozenSet[str] = frozenset("not never no neither nor".split())
#: Adverbs that the formulas contain; all others change nothing of the mood.
TELLING_ADVERBS: FrozenSet[str] = HABITUAL | NEGATING | QUESTION_WORDS | frozenset(["better", "about", "rather"])
#: Verbs of wishes that a unit may carry out: "I want the mug".
WISHING: FrozenSet[str] = frozenset(["want", "need"])
#: With these somebody gives an opinion: "I would say ...".
SAYING: FrozenSet[str] = frozenset("say think guess suppose assume imagine believe mean know do".split())
#: Behind one of these and a person stands what the person does: "watch me turn left".
WATCHING: FrozenSet[str] = frozenset("watch see hear observe notice feel make have".split())
#: Words that stand for an opinion of what was said: "that's fine".
EVALUATIONS: FrozenSet[str] = frozenset(
    "ok okay fine good great right correct wrong true false nice cool perfect enough bad better all funny awesome amazing".split()
)
OPINION_SUBJECTS: FrozenSet[str] = frozenset(["that", "this", "it"])
#: One is in them, and in no place.
MOODS: FrozenSet[str] = frozenset("hurry rush mood trouble pain love danger need charge luck panic".split())
#: Adverbs that are places.
PLACE_ADVERBS: FrozenSet[str] = frozenset("here there home upstairs downstairs outside inside".split())
#: Said around a command without making a request of it.
PADDING: FrozenSet[str] = frozenset("please just really kindly maybe perhaps possibly actually also".split())
#: An utterance of nothing but these is talk; with what is answered.
GREETINGS: FrozenSet[str] = frozenset("hello hi hey bye goodbye morning evening night afternoon welcome".split())
THANKS: FrozenSet[str] = frozenset("thanks thank thankyou cheers".split())
CHATTER: FrozenSet[str] = frozenset(
    "ok okay yes yeah yep no nope sorry please well right alright fine sure good great nice cool wow done job robot you "
    "very so much a lot oh ah all perfect awesome pardon excuse me".split()
)
#: What is answered, by the reason for which something is talk.
TALK_REPLIES: Dict[str, str] = {"thanks": "You are welcome.", "greeting": "Hello.", "chatter": "All right."}
