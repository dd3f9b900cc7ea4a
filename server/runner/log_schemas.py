"""A log of another program as it is answered: what it was taken for, what is still to be asked, how it looks."""

from __future__ import annotations

from typing import Literal

from pydantic import Field

from core.words.message import Message
from server.http.schemas import Answer

Motion = Literal["joints", "quaternion", "matrix", "rotation_vector", "roll_pitch_yaw"]


class LogQuestion(Answer):
    """What neither names nor samples tell: a key of the mapping that somebody has to choose a value for."""

    key: str = Field(description="Key of the mapping.", examples=["wrench.sign"])
    choices: list[str] = Field(description="Values that it may have.", examples=[["1", "-1"]])
    likely: str | None = Field(description="The one that most speaks for; null where nothing speaks for any.", examples=["1"])
    reason: Message = Field(description="Why it cannot be told.")


class LogChange(Answer):
    """A key of the mapping that may have been taken wrongly."""

    key: str = Field(description="Key of the mapping.", examples=["wrench.torque_unit"])
    value: str = Field(description="What it was taken for; empty for a number that nobody has stated.", examples=["N m"])
    choices: list[str] = Field(description="Values that it may have; empty for a number.", examples=[["N m", "N mm"]])


class LogColumns(Answer):
    """Columns that belong together."""

    columns: list[str] = Field(description="Their names, or numbers from 1 where the file has none.", examples=[["fx", "fy", "fz"]])
    unit: str | None = Field(description="Their unit in the log; null where they have none.", examples=["N"])


class LogClock(Answer):
    """Where columns are, and the times of their rows."""

    file: str | None = Field(description="The file, or the topic of the bag; null where there is only one.", examples=["wrench.csv"])
    time: str | None = Field(description="Column of the times; null of poses that somebody averaged.", examples=["t"])
    unit: str = Field(description="Unit of the times.", examples=["us"])
    begins_s: float = Field(description="Added to its times, since its clock is behind, s.", examples=[0.0])


class LogUnderstood(Answer):
    """What the columns of a log were taken for."""

    rows_read: int = Field(description="Rows of the wrench in the log, or of the joints where it has none.", examples=[6200])
    rows_kept: int = Field(description="Those that the recording has.", examples=[6180])
    rows_repeated: int = Field(description="Rows left out since they have the time of the row before.", examples=[0])
    rows_outside: int = Field(description="Rows left out since no attitude is known at their times.", examples=[20])
    rate_hz: float = Field(description="Rate of these rows, Hz.", examples=[500.0])
    lasts_s: float = Field(description="From the first to the last row, s.", examples=[12.4])
    force: LogColumns | None = Field(description="The force; null where no wrist sensor is logged.")
    torque: LogColumns | None = Field(description="The torque likewise.")
    clock: LogClock = Field(description="The file of the wrench and its times; of the joints, where there is none.")
    sign: Literal[1, -1] | None = Field(
        description="1: what the sensor exerts on the payload; -1: what the payload exerts on the sensor, turned round in the recording; "
        "null without a wrist sensor.",
        examples=[1],
    )
    axes: Literal["sensor", "base"] | None = Field(
        description="Axes of the wrench in the log; in the recording they are the sensor's. Null without a wrist sensor.",
        examples=["sensor"],
    )
    is_compensated: bool = Field(description="Whether the controller has taken off the payload that it is set to.", examples=[False])
    motion: Motion = Field(description="What the attitude of the sensor comes from.")
    attitude: LogColumns = Field(description="Columns of the joints or of the attitude.")
    joint_torques: LogColumns | None = Field(description="Columns of the joints' torques; null where none are logged.")
    is_inverse: bool = Field(description="Whether they are those of the base in the sensor.", examples=[False])
    motion_clock: LogClock = Field(description="The file of the attitude and its times.")
    motion_hz: float | None = Field(description="Its rate where it has a clock of its own, Hz.", examples=[100.0])
    position: LogColumns | None = Field(description="Position of the sensor in the base; null where it is not logged.")
    base_frame: str | None = Field(description="Link that the joints begin with; null without joints.", examples=["base_link"])
    sensor_frame: str | None = Field(description="Link in which the wrench is; null without joints.", examples=["ft_sensor"])
    late_s: float | None = Field(
        description="By how much the wrench is behind the attitude, s (negative: early); null with one clock, or where it cannot be told.",
        examples=[0.0021],
    )
    late_std_s: float | None = Field(description="Standard uncertainty of that, s.", examples=[0.0004])
    mass_kg: float | None = Field(description="What the payload weighs, as mass, kg; null where the poses do not tell.", examples=[1.31])
    mass_std_kg: float | None = Field(description="Standard uncertainty of that, kg.", examples=[0.02])


class LogLine(Answer):
    """One line of a plot."""

    name: str = Field(description="What it is.", examples=["fx"])
    values: list[float] = Field(description="One for each time.", examples=[[-1.31, -1.29]])


class LogPreview(Answer):
    """The recording thinned out for plots: of each stretch of time the moment with the most unusual force, or joint torques."""

    t_s: list[float] = Field(description="Times, s.", examples=[[0.0, 0.1]])
    force_n: list[LogLine] = Field(
        description="The force that the sensor exerts on the payload, in its axes, N; empty where no wrist sensor is logged."
    )
    torque_n_m: list[LogLine] = Field(description="The torque likewise, N m.")
    joint_torques_n_m: list[LogLine] = Field(description="Torques of the joints, N m; empty where none are logged.")
    joints_rad: list[LogLine] = Field(description="Positions of the joints, rad; empty where the log has none.")
    down: list[LogLine] = Field(description="Where gravity points, in the sensor's axes; empty where the log has joints.")


class LogReading(Answer):
    """How far a log is understood."""

    question: LogQuestion | None = Field(description="What has to be answered before it can go on; null where nothing has.")
    understood: LogUnderstood | None = Field(description="What it was taken for; null before all is answered.")
    changes: list[LogChange] = Field(description="What may be taken otherwise: answered like a question.")
    contradiction: Message | None = Field(
        description="Why the log cannot be used like this, with the likely slip; null where nothing speaks against it."
    )
    remarks: list[Message] = Field(description="What should be known before its numbers are used.")
    preview: LogPreview | None = Field(description="How it looks; null before all is answered.")
