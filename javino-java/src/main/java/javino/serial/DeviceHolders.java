package javino.serial;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;

/** Finds the processes that have a device open. Needs {@code /proc}, and sees only processes that this user may inspect. */
final class DeviceHolders {
    private DeviceHolders() {}

    private static final String TERMINALS = "/dev/pts/";
    private static final String MASTER = "ptmx";

    /**
     * Returns the other processes that hold the device, such as {@code process 4711 (minicom)}. Empty if none can be seen, or if the
     * device has no file. Leaves out the program at the far end of a pseudo-terminal, because that program is the board.
     */
    static List<String> of(SerialDevice device) {
        if (!device.hasNode()) {
            return List.of();
        }
        Path node = Path.of(device.canonicalAddress());
        return ProcessHandle.allProcesses()
                .filter(process -> !process.equals(ProcessHandle.current()))
                .map(process -> Path.of("/proc", Long.toString(process.pid())))
                .filter(process -> holds(process, node))
                .map(process -> "process " + process.getFileName() + " (" + command(process) + ")")
                .toList();
    }

    private static boolean holds(Path process, Path device) {
        try (Stream<Path> descriptors = Files.list(process.resolve("fd"))) {
            List<Path> all = descriptors.toList();
            return all.stream().anyMatch(descriptor -> device.equals(target(descriptor)))
                    && all.stream().noneMatch(descriptor -> isMaster(descriptor, device));
        } catch (IOException | UncheckedIOException e) {
            return false; // no /proc, another user's process, or a process that has just ended
        }
    }

    private static Path target(Path descriptor) {
        try {
            return Files.readSymbolicLink(descriptor);
        } catch (IOException e) {
            return null; // the descriptor has just been closed
        }
    }

    /**
     * Returns whether a descriptor is the far end of the pseudo-terminal {@code device}. Linux writes the terminal's number to
     * {@code fdinfo}.
     */
    private static boolean isMaster(Path descriptor, Path device) {
        Path target = target(descriptor);
        if (target == null || !target.endsWith(MASTER) || !device.toString().startsWith(TERMINALS)) {
            return false;
        }
        try {
            Path info = descriptor.getParent().resolveSibling("fdinfo").resolve(descriptor.getFileName());
            String number = device.toString().substring(TERMINALS.length());
            return Files.readAllLines(info).contains("tty-index:\t" + number);
        } catch (IOException e) {
            return false; // the descriptor has just been closed
        }
    }

    private static String command(Path process) {
        try {
            return Files.readString(process.resolve("comm")).strip();
        } catch (IOException e) {
            return "ended by now";
        }
    }
}
