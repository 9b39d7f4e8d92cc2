package javino.serial;

import java.util.Set;

/** The meaning of a driver's error code for a device that could not be opened. */
enum DriverErrorCode {
    NO_SUCH_PORT,
    BUSY,
    OPEN_IN_THIS_PROGRAM,
    NO_PERMISSION,
    OTHER;

    // errno of Linux and macOS; only EAGAIN (another process holds the lock) differs
    private static final Set<Integer> POSIX_NO_DEVICE =
            Set.of(5 /* EIO */, 6 /* ENXIO */, 19 /* ENODEV */, 20 /* ENOTDIR */, 21 /* EISDIR */, 25 /* ENOTTY */);
    private static final Set<Integer> POSIX_NOT_ALLOWED = Set.of(1 /* EPERM */, 13 /* EACCES */);
    private static final Set<Integer> POSIX_BUSY = Set.of(11 /* EAGAIN */, 16 /* EBUSY */, 35 /* EAGAIN on macOS */);
    private static final int POSIX_ENOENT = 2;

    // GetLastError of Windows: ERROR_ACCESS_DENIED means that another program has the port open
    private static final Set<Integer> WINDOWS_NO_DEVICE =
            Set.of(2 /* ERROR_FILE_NOT_FOUND */, 3 /* ERROR_PATH_NOT_FOUND */);
    private static final Set<Integer> WINDOWS_BUSY =
            Set.of(5 /* ERROR_ACCESS_DENIED */, 32 /* ERROR_SHARING_VIOLATION */);

    /** @param exists whether the device's file exists */
    static DriverErrorCode posix(int code, boolean exists) {
        if (code == POSIX_ENOENT) {
            // jSerialComm also uses code 2 if this program already has the port open
            return exists ? OPEN_IN_THIS_PROGRAM : NO_SUCH_PORT;
        }
        if (!exists || POSIX_NO_DEVICE.contains(code)) {
            return NO_SUCH_PORT;
        }
        return POSIX_NOT_ALLOWED.contains(code) ? NO_PERMISSION : POSIX_BUSY.contains(code) ? BUSY : OTHER;
    }

    static DriverErrorCode windows(int code) {
        return WINDOWS_NO_DEVICE.contains(code) ? NO_SUCH_PORT : WINDOWS_BUSY.contains(code) ? BUSY : OTHER;
    }
}
