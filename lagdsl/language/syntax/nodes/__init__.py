"""The syntax tree: product of the syntax floor.

Source shape only: nothing is resolved. Every node carries its span, which does not take part in comparison, so
`parse(print(tree)) == tree`. Trees are immutable; children are tuples.
"""

from lagdsl.language.syntax.nodes.declarator import *  # noqa: F403
from lagdsl.language.syntax.nodes.expression import *  # noqa: F403 this package is one vocabulary, in three files
from lagdsl.language.syntax.nodes.item import *  # noqa: F403
