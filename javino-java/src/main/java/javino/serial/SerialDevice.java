package javino.serial;

import java.io.File;
import java.io.IOException;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.Locale;

/**
 * The name and the path of a serial device. On Linux and macOS, the path of a name without a slash is {@code /dev/NAME}. On Windows the
 * path is the name itself.
 */
record SerialDevice(String name, String path) {
    private static final String DOS_NAMESPACE = "\\\\.\\";

    static SerialDevice of(String name) {
        return of(name, System.getProperty("os.name", ""));
    }

    static SerialDevice of(String name, String operatingSystem) {
        if (operatingSystem.startsWith("Windows")) {
            return new SerialDevice(
                    name, name.startsWith(DOS_NAMESPACE) ? name.substring(DOS_NAMESPACE.length()) : name);
        }
        return new SerialDevice(name, name.contains("/") ? name : "/dev/" + name);
    }

    /** Returns one address for all names of this device: the path without symbolic links. */
    String canonicalAddress() {
        if (!hasNode()) {
            return path.toUpperCase(Locale.ROOT); // COM8 and com8 are one port
        }
        try {
            return Path.of(path).toRealPath().toString();
        } catch (IOException | InvalidPathException e) {
            return path; // a missing device has no other name
        }
    }

    boolean exists() {
        return !hasNode() || new File(path).exists(); // without a device file, only the driver knows
    }

    /** Returns whether the device has a file. Windows devices have none. */
    boolean hasNode() {
        return path.contains("/");
    }
}
