/**
 * @file
 * Includes Javino.h under another name, for computers on which another library also has a Javino.h.
 */
#ifndef ARGO_JAVINO_H
#define ARGO_JAVINO_H

#include "Javino.h"

#endif
