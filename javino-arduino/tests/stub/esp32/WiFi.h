#include "../Network.h"
