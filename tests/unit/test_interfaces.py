"""The MD5 sums of all our messages, services and actions: whoever changes one must change this table too.

The sums of 2012, which must never change, are in test_interfaces_2012.py.
"""

import importlib
from typing import Dict

import pytest
from roboframenet_msgs.msg import FilledSemanticFrameActionGoal, PlanNode, ServerProfile

from roboframenet_testing.workspace import packages

SUMS = {
    "location_memorizer/GetLocation": "063bc9ef3579ffcc1f68f8803767c82b",
    "roboframenet_msgs/AddFrame": "cb6a241b274ea486767393c609cdf1cb",
    "roboframenet_msgs/AddLexicalUnit": "cb6a241b274ea486767393c609cdf1cb",
    "roboframenet_msgs/Clause": "2570b7fbdbf9b449c5c87d8fe3c798c2",
    "roboframenet_msgs/Command": "06441d8825ad95b667cb02e75e8084ac",
    "roboframenet_msgs/CommandLexicalUnits": "d7c34f498d8dbfe42900e1ac89ff1e0e",
    "roboframenet_msgs/CommandParse": "b7d3e2439acf18ae2d803912093d4199",
    "roboframenet_msgs/CommandPlan": "5b76f4237c06be2ad59fcce874986dba",
    "roboframenet_msgs/CommandSemanticFrames": "5b76f4237c06be2ad59fcce874986dba",
    "roboframenet_msgs/CommandStatus": "ab7d69c89dff3871b40ffa42ed7df221",
    "roboframenet_msgs/EmbeddedFrame": "07a77a275c818f4f02cbbf04637db4cd",
    "roboframenet_msgs/EmptyFrameElement": "a29b0317b8ca9f43f3140ecb78df89fc",
    "roboframenet_msgs/EmptySemanticFrame": "7e363b67e656a5799fe51a2012c51f8a",
    "roboframenet_msgs/EmergencyStop": "68a20ad1771384b43f825cc3239f795d",
    "roboframenet_msgs/ExecuteCommandAction": "a4b2ce98a43b97aa6d8ca69c9da70a94",
    "roboframenet_msgs/Experience": "58392715ab1c30ec8ebeb53c700d6e0f",
    "roboframenet_msgs/ExperienceCell": "e53631626de49ad42453e56e64a3464d",
    "roboframenet_msgs/FileProblem": "231204bdcb0bfcc41dbb4dc8110faf7c",
    "roboframenet_msgs/FileProblems": "6baa79bd12d94098d04916271a99d088",
    "roboframenet_msgs/FilledFrameElement": "e57a85352b22994f46cb6d7ccbb64da8",
    "roboframenet_msgs/FilledLexicalUnit": "6a8cb181df1bc63b3988099eee52c247",
    "roboframenet_msgs/FilledLexicalUnitList": "ef58cd811a0a319433ad38d92b17ad4a",
    "roboframenet_msgs/FilledSemanticFrame": "af2ebb4070173b2d608a60ad2d4bb7d7",
    "roboframenet_msgs/FilledSemanticFrameAction": "155f2082a80e8d33020a74c63f2ac0f6",
    "roboframenet_msgs/FilledSemanticFrameList": "aac6e5d851941e02a5198adc12df4969",
    "roboframenet_msgs/FilledSemanticFrameListList": "737111e9f6697d31eca2c3093b6a96ef",
    "roboframenet_msgs/Fleet": "d2e76b36b4c23a31eb27e7d74504c8dc",
    "roboframenet_msgs/FleetMember": "75279319f89d47a514e3ce8db853a38d",
    "roboframenet_msgs/FleetRobot": "2afa5ab6a1d9cfde393e9276c2a6cafd",
    "roboframenet_msgs/FleetService": "4104272e643cd2d2bba00b1b46414668",
    "roboframenet_msgs/FrameCallback": "befc48e49677da57988f2e6553a37f3e",
    "roboframenet_msgs/FrameCatalogue": "bc2b1158c286c92ead343daa471ea795",
    "roboframenet_msgs/FrameServers": "8e5136749a0ca1cfcb5d90792fd1b264",
    "roboframenet_msgs/GetEmptyFrame": "04219de4717ce8422705fc0a0c034202",
    "roboframenet_msgs/HeededElement": "6a7eb758bbfe9bc27a64ff03e6697d2b",
    "roboframenet_msgs/KnownName": "8c88d6e9e3ec55fb75efe3cc8092bf47",
    "roboframenet_msgs/KnownNames": "66d6a2aceddbb587bc9c830a4a59e045",
    "roboframenet_msgs/Learned": "052a335457dbc2fac4c21f205348862f",
    "roboframenet_msgs/LearnedItem": "82ca966812c643ad0342e0039110d58b",
    "roboframenet_msgs/LexicalUnitReading": "85db7633d5df0c383c97487518d9e959",
    "roboframenet_msgs/Lexicon": "ccf56eabb845a05f5695134bab46cff4",
    "roboframenet_msgs/Locations": "a528a136f6c6b68beaf8e529bd27b9ef",
    "roboframenet_msgs/Measure": "15150342e0b08823970d4fe81b825ee4",
    "roboframenet_msgs/Modifier": "24b41d3269db8e440ea2a7e52c8ae7bb",
    "roboframenet_msgs/OrderDue": "f94acd631db031498cc8bf51d07dbb61",
    "roboframenet_msgs/Phrase": "32d347d96d47cfe1182206edf389f22f",
    "roboframenet_msgs/Plan": "df33240312b8b407d22fb40c90bf420b",
    "roboframenet_msgs/PlanCandidate": "485b62e07596ae5771263767b1ec44b5",
    "roboframenet_msgs/PlanNode": "8c39fbcdfa91e0f78ce32fc7ae74c8a3",
    "roboframenet_msgs/Procedure": "737111e9f6697d31eca2c3093b6a96ef",
    "roboframenet_msgs/RegisterServer": "27d4ae85e8ec7d4bcc8808f63046df8a",
    "roboframenet_msgs/RegisterWithFrame": "d8348aca95ebc2a23cee1717f1fa3def",
    "roboframenet_msgs/Reply": "53207c57113fc63f3bc152c4c079526f",
    "roboframenet_msgs/ServerExperience": "f54c634e7169caafd9ff5d177db6940b",
    "roboframenet_msgs/ServerProfile": "974f05c8aee5e177a480a10353a37bad",
    "roboframenet_msgs/ServerRule": "0d2baf8b0499cbc4206bc540d7fcc682",
    "roboframenet_msgs/ServerSetting": "24307592ca0f6b4396eea0220039c7e9",
    "roboframenet_msgs/SourceFile": "44f2319ba1d78766f6f517c8103addc4",
    "roboframenet_msgs/StageEvent": "4737efc7f5e5bbb6fbd1c5736b40ebdf",
    "roboframenet_msgs/StandingOrder": "16998fd1acd6bafcc3682cabe78c2c92",
    "roboframenet_msgs/StandingOrders": "95d902e910c748b513b9b83b3b0d32d3",
    "roboframenet_msgs/StoppedPlan": "8b51e0df2f86a7ce943c6840f8653875",
    "roboframenet_msgs/StopReport": "5c2bbe89a2e1a04d707f491c0ac31dd5",
    "roboframenet_msgs/TimeExpression": "63b35963cf0bd5db3a699e1df77d1eb2",
    "roboframenet_msgs/TriedFrame": "e47996af1a88dd8bb610e557c46241f3",
    "roboframenet_msgs/TypedArgument": "48c0c878ab8cbab6ef682927d3369b32",
    "roboframenet_msgs/UpdateWorld": "e3264926b47480c87cc5e987c168c4f9",
    "roboframenet_msgs/World": "5707d471d086868230f05bbf32ba2c4e",
    "roboframenet_msgs/WorldObject": "bdfc6a6f004b549e1fd1447e013c668d",
    "roboframenet_msgs/WorldRelation": "fd0ddba041ad43903fe35ccce987df8b",
    "roboframenet_msgs/WorldUpdate": "c46e4a5ddb1a7e823a6c5c1f9d77be4f",
    "stanford_parser_msgs/Alternative": "37d3bdbdc33431571e4c1bbfddd966bf",
    "stanford_parser_msgs/Dependency": "cdc828bde2cbc087845b7c347e45a5ee",
    "stanford_parser_msgs/Parse": "094e3dbdff171c4bff80579d73b3ed1b",
    "stanford_parser_msgs/SquashedParseTreeNode": "8e3f507a30ff03f4eed132c8e51d902b",
    "stanford_parser_msgs/UniversalWord": "5fa1dcc77286b324570edd28d5c1bf77",
}


def defined() -> Dict[str, str]:
    """Return the generated module of each interface of our packages, by package and name."""
    folders = (("msg", "msg", ""), ("srv", "srv", ""), ("action", "msg", "Action"))
    return {
        f"{package}/{path.stem}{suffix}": f"{package}.{module}"
        for folder, module, suffix in folders
        for package, place in packages().items()
        for path in place.glob(f"{folder}/*.{folder}")
    }


def test_table_lists_exactly_our_interfaces():
    assert set(SUMS) == set(defined())


@pytest.mark.parametrize("name", sorted(defined()))
def test_sum_agrees_with_the_table(name):
    interface = getattr(importlib.import_module(defined()[name]), name.split("/")[1])
    assert interface._md5sum == SUMS.get(name)


def test_default_profile_means_a_registration_of_2012():
    profile = ServerProfile()
    assert profile.purpose == ServerProfile.ACTS
    assert not profile.action_type  # FilledSemanticFrame
    assert not profile.heeds  # what the frame declares
    assert not profile.occupies  # everything
    assert not profile.settings
    assert profile.longest_goal.is_zero()


def test_goal_of_2012_has_the_string_that_typed_arguments_travel_in():
    assert FilledSemanticFrameActionGoal().header.frame_id == ""


def test_kinds_of_a_plan_have_different_numbers():
    kinds = [value for name, value in vars(PlanNode).items() if name.isupper() and name not in ("HOLDS", "BEGINS")]
    assert sorted(kinds) == list(range(1, len(kinds) + 1))


def test_no_constant_contains_its_comment() -> None:
    """A string constant goes on to the end of its line, also behind '#'."""
    lines = [
        line for one in packages().values() for path in one.glob("msg/*.msg") for line in path.read_text().splitlines()
    ]
    assert not [line for line in lines if line.startswith("string ") and "=" in line.split("#")[0] and "#" in line]
