// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesWriteTables_h
#define OrthoSlicesWriteTables_h

class vtkTable;

namespace orthoslices
{
struct Reconstruction;

/// Port 2: the histogram of polygon sizes.
void WriteHistogram(const Reconstruction& result, vtkTable* table);

/// Port 3: agreement of every contour with the orthogonal families.
void WriteContourTable(const Reconstruction& result, vtkTable* table);

/// Port 4: agreement of every slice with the orthogonal families, and its shift.
void WriteSliceTable(const Reconstruction& result, vtkTable* table);

/// Port 5: the undecided places, and where to slice next.
void WriteUndecidedTable(const Reconstruction& result, vtkTable* table);

/// Port 6: what is wrong with the input, and what became of it.
void WriteProblemTable(const Reconstruction& result, vtkTable* table);
}

#endif
