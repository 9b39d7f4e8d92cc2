package javino.tcp;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.AtomicMoveNotSupportedException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.security.GeneralSecurityException;
import java.security.KeyFactory;
import java.security.MessageDigest;
import java.security.PrivateKey;
import java.security.cert.CertificateFactory;
import java.security.cert.X509Certificate;
import java.security.spec.PKCS8EncodedKeySpec;
import java.util.Base64;
import java.util.Collection;
import java.util.HexFormat;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * A folder with the certificates of boards and of this computer, as PEM files. {@code robot_4433.crt} belongs to the board at
 * {@code tls://robot:4433}. {@code computer.crt} and {@code computer.key} belong to the computer. Each opening of a port reads the files.
 *
 * @param path the folder, which need not exist
 */
public record TlsFolder(Path path) {
    private static final String KEY_COMMAND = "openssl pkcs8 -topk8 -nodes -in OLD.key -out computer.key";
    private static final Pattern KEY =
            Pattern.compile("-----BEGIN PRIVATE KEY-----([A-Za-z0-9+/=\\s]+)-----END PRIVATE KEY-----");

    /** Returns the folder that the system property {@code javino.tls} names. By default {@code .argo/tls} in the user's home. */
    public static TlsFolder ofUser() {
        String given = System.getProperty("javino.tls");
        return new TlsFolder(given != null ? Path.of(given) : Path.of(System.getProperty("user.home"), ".argo", "tls"));
    }

    Path fileOf(TcpAddress address) {
        return path.resolve(address.toString().replaceAll("[^a-z0-9.-]", "_") + ".crt");
    }

    /**
     * Returns the certificate that the board at {@code address} must show. Empty if none is known.
     *
     * @throws IOException if the board's file holds no certificate; the message is for a person
     */
    Optional<X509Certificate> boardAt(TcpAddress address) throws IOException {
        Path file = fileOf(address);
        return Files.exists(file) ? Optional.of(certificates(file)[0]) : Optional.empty();
    }

    void keep(TcpAddress address, X509Certificate certificate) throws IOException, GeneralSecurityException {
        Files.createDirectories(path);
        Path part = Files.createTempFile(path, "new", ".crt");
        Files.writeString(part, pem("CERTIFICATE", certificate.getEncoded()));
        try {
            Files.move(part, fileOf(address), StandardCopyOption.ATOMIC_MOVE);
        } catch (AtomicMoveNotSupportedException e) {
            Files.move(part, fileOf(address), StandardCopyOption.REPLACE_EXISTING);
        }
    }

    /** Returns the file for the computer's certificate. The file need not exist. */
    public Path computerFile() {
        return path.resolve("computer.crt");
    }

    /** The computer's key and its chain: its own certificate, followed by the issuers' certificates. */
    public record Identity(PrivateKey key, X509Certificate[] chain) {}

    /**
     * Returns the computer's key and certificate. Empty if there are none.
     *
     * @throws IOException if one of the two files is missing or cannot be read; the message is for a person
     */
    public Optional<Identity> computer() throws IOException {
        Path keyFile = path.resolve("computer.key");
        if (!Files.exists(computerFile()) && !Files.exists(keyFile)) {
            return Optional.empty();
        }
        for (Path file : new Path[] {computerFile(), keyFile}) {
            if (!Files.exists(file)) {
                throw new IOException("the file " + file
                        + " is missing: the computer's own certificate is in computer.crt, its key in computer.key");
            }
        }
        X509Certificate[] chain = certificates(computerFile());
        return Optional.of(new Identity(key(keyFile, chain[0].getPublicKey().getAlgorithm()), chain));
    }

    /** Returns the certificate's SHA-256 in the format of {@code openssl x509 -fingerprint -sha256}. */
    public static String fingerprint(X509Certificate certificate) {
        try {
            byte[] digest = MessageDigest.getInstance("SHA-256").digest(certificate.getEncoded());
            return "SHA-256 " + HexFormat.ofDelimiter(":").withUpperCase().formatHex(digest);
        } catch (GeneralSecurityException e) {
            throw new IllegalStateException(e); // every Java has SHA-256, and the certificate has been decoded before
        }
    }

    /**
     * Returns the certificates in {@code file}, at least one.
     *
     * @throws IOException if the file holds no certificate or cannot be read; the message is for a person
     */
    public static X509Certificate[] certificates(Path file) throws IOException {
        try {
            Collection<? extends java.security.cert.Certificate> found = CertificateFactory.getInstance("X.509")
                    .generateCertificates(new ByteArrayInputStream(Files.readAllBytes(file)));
            if (!found.isEmpty()) {
                return found.toArray(X509Certificate[]::new);
            }
        } catch (GeneralSecurityException e) {
            // reported below
        }
        throw new IOException(
                "the file " + file + " holds no certificate; one begins with -----BEGIN CERTIFICATE-----");
    }

    private static PrivateKey key(Path file, String algorithm) throws IOException {
        Matcher form = KEY.matcher(Files.readString(file, StandardCharsets.ISO_8859_1));
        try {
            if (form.find()) {
                byte[] key = Base64.getMimeDecoder().decode(form.group(1));
                return KeyFactory.getInstance(algorithm).generatePrivate(new PKCS8EncodedKeySpec(key));
            }
        } catch (GeneralSecurityException | IllegalArgumentException e) {
            throw new IOException(
                    "the file " + file + " holds no key for the certificate in computer.crt: " + e.getMessage(), e);
        }
        throw new IOException("the file " + file
                + " holds no key that can be read: a key in PKCS #8 without a password begins with"
                + " -----BEGIN PRIVATE KEY-----; \"" + KEY_COMMAND + "\" writes it");
    }

    static String pem(String what, byte[] bytes) {
        return "-----BEGIN " + what + "-----\n"
                + Base64.getMimeEncoder(64, new byte[] {'\n'}).encodeToString(bytes) + "\n-----END " + what + "-----\n";
    }
}
