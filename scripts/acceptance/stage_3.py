"""The acceptance of the third stage, as its users try it: nothing lost, nobody misled."""

from acceptance import bags, eye, maps_kept, messages, package, reasons, refusals, robot_network, shell, time_order

LINES = [*maps_kept.LINES, *reasons.LINES, *time_order.LINES, *robot_network.LINES, *messages.LINES, *bags.LINES,
         *shell.LINES, *refusals.LINES, *eye.LINES, *package.LINES]
