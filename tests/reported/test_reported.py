"""Faults that users reported, each as the smallest input that shows it, with the value that is right.

The value is a closed form or follows from another formulation, never from our own output. A section holds one report; texts
that are longer than a screen, and files of other tools, lie in `texts` beside this file.
"""

from __future__ import annotations

# ---- bounces: a contact that is located as closing strikes -------------------------------------------------------------

# ---- fixed steps after bounces -----------------------------------------------------------------------------------------

# ---- angles of cut joints: whole turns ---------------------------------------------------------------------------------

# ---- a ball joint that closes a loop half a turn from its start --------------------------------------------------------

# ---- starts: guesses choose branches, explicit values hold -------------------------------------------------------------

# ---- names of connected variables --------------------------------------------------------------------------------------

# ---- models in which nothing is free to move ---------------------------------------------------------------------------

# ---- certificates of statics -------------------------------------------------------------------------------------------

# ---- linearization of circuits, verdicts on sampled loops --------------------------------------------------------------

# ---- lowest and highest of outputs -------------------------------------------------------------------------------------

# ---- derivations: stability and equilibria -----------------------------------------------------------------------------

# ---- derivations: names and letters ------------------------------------------------------------------------------------

# ---- derivations: what is printed is short -----------------------------------------------------------------------------

# ---- pictures: springs and bars ----------------------------------------------------------------------------------------

# ---- robots: URDF ------------------------------------------------------------------------------------------------------

# ---- robots: MJCF ------------------------------------------------------------------------------------------------------
