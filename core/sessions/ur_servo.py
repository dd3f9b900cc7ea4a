"""The program that runs on a Universal Robots controller while Heft moves it, and the registers in which both talk.

Registers from 24 on are those that a controller keeps for RTDE clients. The watchdog is the controller's own: where the inputs stay away
for longer than `WATCHDOG_S` the program ends and the robot brakes.
"""

from __future__ import annotations

from core.sessions.rtde import Value

WATCHDOG_S = 0.1
NUMBER, MODE = "input_int_register_24", "input_int_register_25"
JOINTS = tuple(f"input_double_register_{k}" for k in range(24, 30))
OBEYS, FOLLOWED = "output_int_register_24", "output_int_register_25"
WAIT, FOLLOW, BRAKE, END = 0, 1, 2, 3
"""What `MODE` asks for."""

INPUTS = (NUMBER, MODE, *JOINTS)

_PROGRAM = """def heft_servo():
  write_output_integer_register(24, 0)
  rtde_set_watchdog("input_int_register_24", {watchdog_hz}, "stop")
  write_output_integer_register(25, 0)
  write_output_integer_register(24, {token})
  mode = 0
  while mode != 3:
    mode = read_input_integer_register(25)
    if mode == 1:
      number = read_input_integer_register(24)
      a = read_input_float_register(24)
      b = read_input_float_register(25)
      c = read_input_float_register(26)
      d = read_input_float_register(27)
      e = read_input_float_register(28)
      f = read_input_float_register(29)
      write_output_integer_register(25, number)
      servoj([a, b, c, d, e, f], 0, 0, {period}, {lookahead}, {gain})
    elif mode == 2:
      stopj({braking})
      sync()
    else:
      sync()
    end
  end
  stopj({braking})
  write_output_integer_register(24, 0)
end
"""


def write_program(*, token: int, period: float, lookahead_s: float, gain: float, braking_rad_s2: float) -> str:
    """The program as URScript.

    Args:
        token: that `OBEYS` shows as long as this program runs; a register keeps its value when a program is ended.
        period: of the controller, s.
        lookahead_s, gain: of `servoj`: how far ahead it smooths, and how stiff it follows.
        braking_rad_s2: of `stopj`, of the leading joint.
    """
    watchdog_hz = round(1.0 / WATCHDOG_S)
    return _PROGRAM.format(token=token, watchdog_hz=watchdog_hz, period=period, lookahead=lookahead_s, gain=gain, braking=braking_rad_s2)


def read_number(values: dict[str, Value], name: str) -> float:
    """A value that is one number."""
    value = values[name]
    assert isinstance(value, int | float)
    return float(value)


def read_vector(values: dict[str, Value], name: str) -> tuple[float, ...]:
    """A value that is several."""
    value = values[name]
    assert isinstance(value, tuple)
    return value
