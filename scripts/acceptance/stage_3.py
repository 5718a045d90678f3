"""The acceptance of the third stage: nothing lost, nobody misled."""

from acceptance import messages, robot_network, time_order

LINES = [*time_order.LINES, *robot_network.LINES, *messages.LINES]
