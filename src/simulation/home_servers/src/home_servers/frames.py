"""Which skill carries out which frame: one table for each domain."""

from pathlib import Path
from typing import Any, Dict, Mapping

import yaml

from home_servers import checking, going, handling, housework, looking, talking
from home_servers.skills import Skill

#: Settings, and the devices that they are of.
SETTINGS: Dict[str, str] = {"volume": "radio", "music": "radio", "temperature": "thermostat", "heat": "thermostat"}
#: By domain and frame. A frame that the frame graph composes of others is here only where the graph drops an element.
DOMAINS: Dict[str, Dict[str, Skill]] = {
    "aliveness": {"waiting": going.wait},
    "cheffing": {
        "baking": housework.treat("bake", "food"),
        "boiling": housework.treat("boil", "food"),
        "frying": housework.treat("fry", "food"),
        "cooking": housework.cook,
        "chopping": housework.treat("chop", "item"),
        "slicing": housework.treat("slice", "item"),
        "cutting_food": housework.treat("cut", "item"),
        "mixing": housework.treat("mix", "parts"),
        "peeling": housework.treat("peel", "source"),
        "pouring": housework.pour,
    },
    "devices": {
        "brightening": handling.level(20.0, SETTINGS),
        "dimming": handling.level(-20.0, SETTINGS),
        "increasing": handling.level(20.0, SETTINGS),
        "decreasing": handling.level(-20.0, SETTINGS),
        "cancelling": handling.cancel,
        "charging": going.charge,
        "docking": going.dock,
        "pressing": handling.press,
        "restarting": handling.restart,
    },
    "following": {"following": going.follow, "guiding": going.guide},
    "gesturing": {
        "bowing": talking.gesture("bow", "addressee"),
        "dancing": talking.gesture("dance", "partner"),
        "nodding": talking.gesture("nod", "addressee"),
        "playing": talking.play,
        "pointing": talking.gesture("point", "target"),
        "waving": talking.gesture("wave", "addressee"),
    },
    "kitchen_cleaning": {
        "cleaning": housework.clean,
        "drying_dishes": housework.treat("dry", "object"),
        "emptying": handling.empty,
        "rinsing": housework.treat("rinse", "object"),
        "scrubbing": housework.treat("scrub", "object"),
        "sweeping": housework.treat("sweep", "object"),
        "tidying": housework.tidy,
        "washing_dishes": housework.treat("wash_dish", "object"),
        "wiping": housework.treat("wipe", "object"),
    },
    "laundering": {
        "folding": housework.treat("fold", "item"),
        "hanging_clothes": housework.hang,
        "ironing": housework.treat("iron", "item"),
        "loading": handling.load,
        "sorting_laundry": housework.sort_laundry,
        "washing_clothes": housework.treat("wash_cloth", "clothes"),
    },
    "moving": {"facing": going.face},
    "navigation": {
        "being_in_category": looking.be_in_category,
        "being_located": looking.be_located,
        "departing": going.depart,
        "inspecting": checking.inspect,
        "locating": looking.locate,
        "moving_along_path": going.move_along,
        "navigating_to_location": going.navigate,
        "perceiving": looking.perceive,
        "photographing": looking.photograph,
    },
    "observing": {
        "comparing": looking.compare,
        "counting": looking.count,
        "finding_out": looking.find_out,
        "identifying": looking.identify,
        "patrolling": going.patrol,
        "scouring": looking.scour,
        "verifying": checking.verify,
    },
    "pick_and_place": {
        "attaching": handling.attach,
        "bringing": handling.bring,
        "closing": handling.portal("container_portal", "close"),
        "detaching": handling.detach,
        "discarding": handling.discard,
        "extending_arm": handling.arm("extended"),
        "fetching": handling.fetch,
        "giving": handling.give,
        "giving_drink": handling.give_drink,
        "grasping": handling.grasp,
        "lifting": handling.take,
        "locking": handling.portal("container_portal", "lock"),
        "lowering": handling.raise_thing("down"),
        "opening": handling.portal("container_portal", "open"),
        "placing": handling.put,
        "pulling": handling.push("nearer"),
        "pushing": handling.push("forward"),
        "raising": handling.raise_thing("up"),
        "retracting_arm": handling.arm("tucked"),
        "rotating": handling.rotate,
        "sliding": handling.push("forward"),
        "stacking": handling.stack,
        "switching_device": handling.switch,
        "taking": handling.take,
        "throwing": handling.throw,
        "ungrasping": handling.let_go,
        "unlocking": handling.portal("container_portal", "unlock"),
    },
    "socializing": {
        "awaiting": going.await_,
        "greeting": talking.greet,
        "introducing": talking.introduce,
        "meeting": talking.meet,
        "offering": handling.offer,
        "parting": talking.part,
        "serving": handling.serve,
    },
    "speaking": {
        "answering": talking.answer,
        "asking": talking.ask,
        "describing": talking.describe,
        "listing": looking.list_things,
        "reminding": talking.remind,
        "reporting": talking.report,
        "requesting": talking.request,
        "saying": talking.say,
        "telling": talking.tell,
    },
    "props": talking.PROPS,
}
#: By frame.
FRAMES: Dict[str, Skill] = {frame: skill for skills in DOMAINS.values() for frame, skill in skills.items()}
#: By frame, what its server states when it registers; nothing for a frame that is missing.
STATEMENTS: Mapping[str, Mapping[str, Any]] = yaml.safe_load(
    Path(__file__).resolve().with_name("statements.yaml").read_text(encoding="utf-8")
)
#: Frames that need no hand: what a robot without arms can do.
WITHOUT_HANDS = frozenset(
    [
        *DOMAINS["aliveness"],
        *DOMAINS["following"],
        *DOMAINS["moving"],
        *DOMAINS["navigation"],
        *(set(DOMAINS["observing"]) - {"verifying"}),
        *(set(DOMAINS["socializing"]) - {"offering", "serving"}),
        *(set(DOMAINS["speaking"]) - {"answering"}),
        "dancing",
        "nodding",
        "docking",
    ]
)
