// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "pqWritableHelp.h"

#include "pqApplicationCore.h"

#include <QHelpEngine>
#include <QString>

//--------------------------------------------------------------------------------------------------
void pqWritableHelp::startup()
{
  QHelpEngine* engine = pqApplicationCore::instance()->helpEngine();
  if (!engine->isReadOnly())
  {
    return;
  }
  engine->setReadOnly(false);
  // It is open already. Another name closes the file.
  const QString file = engine->collectionFile();
  engine->setCollectionFile(QString());
  engine->setCollectionFile(file);
  engine->setupData();
}
