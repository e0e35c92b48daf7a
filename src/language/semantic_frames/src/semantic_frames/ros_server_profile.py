"""Converts the profile of a server to its message and back."""

import genpy
from roboframenet_msgs import msg

from semantic_frames.server_profile import HeededElement, Purpose, ServerProfile, ServerSetting

#: ``HeededElement.most`` of an element that the server does not heed.
_NONE = -1


def profile_to_message(profile: ServerProfile) -> msg.ServerProfile:
    """Return a profile as a message."""
    return msg.ServerProfile(
        purpose=int(profile.purpose),
        action_type=profile.action_type,
        robot=profile.robot,
        heeds=[
            msg.HeededElement(
                name=heeded.name,
                relations=list(heeded.relations),
                values=list(heeded.values),
                semantic_types=list(heeded.semantic_types),
                most=heeded.most,
            )
            for heeded in profile.heeds
        ]
        + [msg.HeededElement(name=name, most=_NONE) for name in profile.unheeded],
        occupies=list(profile.occupies),
        settings=[
            msg.ServerSetting(node=setting.node, name=setting.name, value=setting.value) for setting in profile.settings
        ],
        longest_goal=genpy.Duration.from_sec(profile.longest_goal_s),
        longest_silence=genpy.Duration.from_sec(profile.longest_silence_s),
    )


def profile_from_message(message: msg.ServerProfile) -> ServerProfile:
    """Return the profile of a message.

    Raises:
        ValueError: there is no such purpose
    """
    return ServerProfile(
        purpose=Purpose(message.purpose),
        action_type=message.action_type,
        robot=message.robot,
        heeds=tuple(
            HeededElement(
                name=heeded.name,
                relations=tuple(heeded.relations),
                values=tuple(heeded.values),
                semantic_types=tuple(heeded.semantic_types),
                most=heeded.most,
            )
            for heeded in message.heeds
            if heeded.most != _NONE
        ),
        unheeded=tuple(heeded.name for heeded in message.heeds if heeded.most == _NONE),
        occupies=tuple(message.occupies),
        settings=tuple(ServerSetting(setting.node, setting.name, setting.value) for setting in message.settings),
        longest_goal_s=message.longest_goal.to_sec(),
        longest_silence_s=message.longest_silence.to_sec(),
    )
