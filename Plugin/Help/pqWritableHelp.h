// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef pqWritableHelp_h
#define pqWritableHelp_h

/**
 * Lets ParaView's window take the help pages of plugins, where it was built with Qt 6.
 *
 * ParaView keeps the pages of plugins in a collection that it makes when it starts. Qt 6 opens a
 * collection for reading only unless told otherwise, and ParaView 5.13 does not say so: it can register
 * no page, and the help button of a filter finds none.
 *
 * ParaView starts this when it has a window and loads the plugin, before it looks for pages in it; its
 * other programs never do.
 */
class pqWritableHelp
{
public:
  /**
   * Opens the collection anew, for writing, if it is for reading only. It is empty then, so nothing is
   * lost; one that can be written stays as it is.
   */
  void startup();

  void shutdown() {}
};

#endif
