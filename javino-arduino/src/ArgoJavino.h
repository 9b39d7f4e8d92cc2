/**
 * @file
 * The library under its own name, for computers on which another library has a Javino.h too.
 */
#ifndef ARGO_JAVINO_H
#define ARGO_JAVINO_H

#include "Javino.h"

#endif
