# SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# A macro of ParaView: opens the inspection view of the reconstruction that is selected in the pipeline
# browser. Macros > Import new macro adds it to the toolbar.

from paraview import servermanager  # finds the modules of plugins

import inspectslices

inspectslices.inspect()
