package javino.sim;

import java.io.File;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;

/**
 * Two pseudo-terminals joined by the program {@code socat}. Bytes written to one terminal are read from the other. Tests and measurements
 * use them as serial devices without a board. Not for Windows.
 */
public final class PseudoTerminals implements AutoCloseable {
    private static final long START_LIMIT_MILLIS = 10_000;

    /** Begins the line that socat prints when both terminals are as they stay. */
    private static final String READY = "starting data transfer loop";

    private final Path directory;
    private final Process socat;

    private PseudoTerminals(Path directory, Process socat) {
        this.directory = directory;
        this.socat = socat;
    }

    /** Returns whether {@code socat} can be started here. */
    public static boolean available() {
        try {
            return socat("-V").waitFor() == 0;
        } catch (IOException e) {
            return false; // socat is not installed
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            return false;
        }
    }

    /**
     * Creates a pair in raw mode.
     *
     * @throws IOException if there is no {@code socat}, or if it made no terminals within ten seconds
     */
    public static PseudoTerminals open() throws IOException, InterruptedException {
        Path directory = Files.createTempDirectory("argo-pty");
        String raw = "pty,raw,echo=0,link=";
        PseudoTerminals pair = new PseudoTerminals(
                directory, socat("-d", "-d", raw + directory.resolve("computer"), raw + directory.resolve("board")));
        try {
            pair.awaitReadiness();
            return pair;
        } catch (IOException | InterruptedException e) {
            pair.close();
            throw e;
        }
    }

    private static Process socat(String... arguments) throws IOException {
        ProcessBuilder socat = new ProcessBuilder("socat");
        socat.command().addAll(List.of(arguments));
        return socat.redirectErrorStream(true).start();
    }

    /** Returns the device that a program opens as the board's port. */
    public File computer() {
        return directory.resolve("computer").toFile();
    }

    /** Returns the device at the board's end. */
    public File board() {
        return directory.resolve("board").toFile();
    }

    /** Removes both terminals. May be called twice. */
    @Override
    public void close() {
        socat.destroy();
        try {
            socat.waitFor();
            Files.deleteIfExists(computer().toPath());
            Files.deleteIfExists(board().toPath());
            Files.deleteIfExists(directory);
        } catch (IOException e) {
            directory.toFile().deleteOnExit(); // at worst an empty temporary directory stays until then
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    /**
     * Waits for both terminals. socat links a terminal before it makes it raw. That would undo the settings of a program that has opened
     * the terminal in between, whose reads would then wait for a byte without end.
     */
    private void awaitReadiness() throws IOException, InterruptedException {
        long end = System.nanoTime() + TimeUnit.MILLISECONDS.toNanos(START_LIMIT_MILLIS);
        InputStream output = socat.getInputStream();
        StringBuilder told = new StringBuilder();
        while (told.indexOf(READY) < 0) {
            boolean isOver = !socat.isAlive() || System.nanoTime() - end > 0;
            told.append(new String(output.readNBytes(output.available()), StandardCharsets.US_ASCII));
            if (isOver && told.indexOf(READY) < 0) {
                throw new IOException("socat made no pseudo-terminals in " + directory + ": " + told);
            }
            TimeUnit.MILLISECONDS.sleep(5);
        }
    }
}
