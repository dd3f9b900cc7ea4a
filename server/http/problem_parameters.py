"""What the words of the service's problems name: each name's meaning, with its unit, and its JSON schema."""

from __future__ import annotations

from typing import Any

NESTED = "NestedMessage"
"""Schema of a message that another one names."""

Json = dict[str, Any]

TEXT: Json = {"type": "string"}
NUMBER: Json = {"type": "number"}
COUNT: Json = {"type": "integer"}
MESSAGE = "message"
"""Which may be a text of outside as well."""
MESSAGES = "messages"
VECTOR: Json = {"type": "array", "items": NUMBER}

PARAMETERS: dict[str, tuple[str, Json | str]] = {
    "account": ("Name of the account.", TEXT),
    "age_s": ("Its age, s.", NUMBER),
    "alarm": ("Identifier of the alarm.", TEXT),
    "by": ("What has the name: obstacle, zone, tool, payload, or saved payload.", TEXT),
    "cause": ("Why the run has none.", MESSAGE),
    "cell": ("Name of the cell.", TEXT),
    "command": ("What was asked.", TEXT),
    "commands": ("What may be asked instead.", MESSAGES),
    "compression": ("Number of the zip's method of compression.", COUNT),
    "contradiction": ("Why the log cannot be used like this.", MESSAGE),
    "draft": ("Identifier of the draft.", TEXT),
    "effect": ("Name of the effect.", TEXT),
    "distance_m": ("Distance that was given, m.", NUMBER),
    "endpoint": ("Method and address.", TEXT),
    "event": ("What was tried.", TEXT),
    "fence": ("Fence of who is in control.", COUNT),
    "file": ("Name of the file.", TEXT),
    "files": ("How many files there are.", COUNT),
    "finished_steps": ("How many steps are recorded.", COUNT),
    "flaw": ("What does not fit.", MESSAGE),
    "folder": ("Name of the folder.", TEXT),
    "found": ("What was found.", TEXT),
    "free_mb": ("Room on the disk, MB.", NUMBER),
    "given": ("How many were given.", COUNT),
    "given_payload": ("Name of the payload that was given.", TEXT),
    "gravity_m_s2": ("Gravity in the base frame now, m/s2.", VECTOR),
    "header": ("Name of the header.", TEXT),
    "holder": ("Who is in control.", TEXT),
    "job": ("Identifier of the job.", TEXT),
    "joints": ("How many joints the robot has.", COUNT),
    "key": ("Name of the field, or name or beginning of the key.", TEXT),
    "kind": ("Kind of the job or the file.", TEXT),
    "kinds": ("What it may be.", MESSAGES),
    "known_at": ("Time of the latest measurement, ISO 8601.", TEXT),
    "last_number": ("Number of the latest command.", COUNT),
    "least_kg": ("The least, kg.", NUMBER),
    "least_m": ("The least, m.", NUMBER),
    "least_m_s": ("The least, m/s.", NUMBER),
    "length_m": ("Length that was given, m.", NUMBER),
    "levels": ("How deep folders may lie.", COUNT),
    "limit_bytes": ("What it may have, bytes.", COUNT),
    "limit_gb": ("What it may have, GB.", NUMBER),
    "limit_s": ("What it may be, s.", NUMBER),
    "log_import": ("Identifier of the import.", TEXT),
    "listed_bytes": ("What the zip says that it has, bytes.", COUNT),
    "measured_at": ("Time of this measurement, ISO 8601.", TEXT),
    "method": ("Method of the request.", TEXT),
    "more": ("How many more do not fit.", COUNT),
    "most_bytes": ("What it may have, bytes.", COUNT),
    "most_m": ("The most, m.", NUMBER),
    "most_files": ("How many there may be.", COUNT),
    "most_kg": ("The most, kg.", NUMBER),
    "most_m_s": ("The most, m/s.", NUMBER),
    "most_drafts": ("How many drafts there may be.", COUNT),
    "most_imports": ("How many imports there may be.", COUNT),
    "most_letters": ("How many letters a name may have.", COUNT),
    "most_saved": ("How many payloads it may hold.", COUNT),
    "motion": ("What is proposed instead.", MESSAGE),
    "moves": ("How often the zone has moved.", COUNT),
    "name": ("Name that was given.", TEXT),
    "names": ("Names of the files.", MESSAGES),
    "needed": ("Roles that may.", MESSAGES),
    "needed_mb": ("Room that is needed, MB.", NUMBER),
    "now": ("Time of the service, ISO 8601.", TEXT),
    "number": ("Number of this command.", COUNT),
    "option": ("Name of the field beside it.", TEXT),
    "origin": ("Where the request comes from.", TEXT),
    "owner": ("What has that name already.", MESSAGE),
    "path": ("Address of the request.", TEXT),
    "payload": ("Name of the payload.", TEXT),
    "payloads": ("Names of those that the cell knows.", MESSAGES),
    "plan": ("First digits of the plan's SHA-256.", TEXT),
    "problem": ("Name that was asked for.", TEXT),
    "reason": ("What the system says.", TEXT),
    "recorded_m_s2": ("Gravity in the recording, m/s2.", VECTOR),
    "refusal": ("Why it was refused.", MESSAGE),
    "retry_after_s": ("When to ask again, s.", NUMBER),
    "role": ("The role.", TEXT),
    "roles": ("The roles.", MESSAGES),
    "run": ("Identifier of the run.", TEXT),
    "saved": ("Identifier of the saved payload.", TEXT),
    "seen_moves": ("How often it had moved when it was seen.", COUNT),
    "sent_fence": ("Fence that was sent.", COUNT),
    "session": ("Identifier of the browser's session.", TEXT),
    "speed_m_s": ("Speed that was asked for, m/s.", NUMBER),
    "state": ("State of the run or the job.", TEXT),
    "unpacked_bytes": ("What it unpacks to, bytes.", COUNT),
    "webhook": ("Identifier of the webhook.", TEXT),
    "what": ("What the zip should hold.", TEXT),
    "where": ("The part of the request, or the file with the key in it.", MESSAGE),
    "who": ("Who asked, or who did it.", TEXT),
    "zone": ("Name of the zone.", TEXT),
}
"""By name. A test wants each that the words of a situation name."""


def describe_parameter(name: str, ref: str) -> Json:
    """A parameter's JSON schema with its meaning; of a name that stands in no table any value, without a meaning.

    Args:
        ref: where schemas are, such as `#/components/schemas/`.
    """
    if name not in PARAMETERS:
        return {}
    words, kind = PARAMETERS[name]
    message = {"anyOf": [TEXT, {"$ref": f"{ref}{NESTED}"}]}
    schema = message if kind == MESSAGE else {"type": "array", "items": message} if kind == MESSAGES else kind
    assert isinstance(schema, dict)
    return {"description": words, **schema}
