"""The acceptance of the third stage, as its users try it: nothing lost, nobody misled."""

from acceptance import bags, eye, messages, package, robot_network, shell, time_order

LINES = [*time_order.LINES, *robot_network.LINES, *messages.LINES, *bags.LINES, *shell.LINES, *eye.LINES,
         *package.LINES]
