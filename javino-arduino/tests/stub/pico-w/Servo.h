#include "../ServoInterface.h"
