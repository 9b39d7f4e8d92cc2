package javino.sim;

import java.io.IOException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import javino.LineSettings;
import javino.NoSuchPortException;
import javino.PortException;
import javino.PortFaultException;
import javino.Transport;
import javino.TransportProvider;

/** Opens {@code replay:FILE}: a {@link ReplayBoard} with the recording in the file. */
public final class ReplayTransportProvider implements TransportProvider {
    @Override
    public String scheme() {
        return "replay";
    }

    @Override
    public Transport open(String address, LineSettings line) throws PortException {
        String port = port(address);
        try {
            return new PluggedBoard(port, ReplayBoard.of(LineRecording.read(Path.of(address)))).open(line);
        } catch (NoSuchFileException | InvalidPathException e) {
            throw new NoSuchPortException(
                    port,
                    "there is no recording " + address + " in " + Path.of("").toAbsolutePath());
        } catch (PortException e) {
            throw e;
        } catch (FileSystemException e) {
            throw new PortFaultException(
                    port, "port " + port + " cannot be opened: its file cannot be read (" + e + ")", e);
        } catch (IOException | IllegalArgumentException e) {
            throw new PortFaultException(port, "port " + port + " cannot be opened: " + e.getMessage(), e);
        }
    }

    @Override
    public String canonicalName(String address) {
        try {
            Path file = Path.of(address);
            return port((Files.exists(file) ? file.toRealPath() : file).toString());
        } catch (IOException | InvalidPathException e) {
            return port(address);
        }
    }
}
