package javino;

import java.util.ArrayList;
import java.util.Iterator;
import java.util.List;
import java.util.ServiceConfigurationError;
import java.util.ServiceLoader;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;

/**
 * Finds services with two class loaders: that of the calling thread and that of this library. In a Jason project, the thread and the
 * library may have different class loaders. A service that cannot be loaded is reported once.
 */
public final class Services {
    private static final System.Logger LOG = System.getLogger(Services.class.getName());

    private static final Set<String> TOLD = ConcurrentHashMap.newKeySet();

    private Services() {}

    /** Returns the providers of {@code service} without creating a service. A provider that both class loaders see appears twice. */
    public static <T> List<ServiceLoader.Provider<T>> providers(Class<T> service) {
        List<ServiceLoader.Provider<T>> found = new ArrayList<>();
        addAll(found, ServiceLoader.load(service));
        addAll(found, ServiceLoader.load(service, service.getClassLoader()));
        return found;
    }

    private static <T> void addAll(List<ServiceLoader.Provider<T>> found, ServiceLoader<T> loader) {
        Iterator<ServiceLoader.Provider<T>> providers = loader.stream().iterator();
        while (true) {
            try {
                if (!providers.hasNext()) {
                    return;
                }
                found.add(providers.next());
            } catch (ServiceConfigurationError e) {
                warn(e); // the loader continues with the next provider
            }
        }
    }

    /** Creates the service of {@code provider}. If that fails, logs a warning and returns null. */
    public static <T> T make(ServiceLoader.Provider<T> provider) {
        try {
            return provider.get();
        } catch (ServiceConfigurationError e) {
            warn(e);
            return null;
        }
    }

    private static void warn(ServiceConfigurationError e) {
        if (TOLD.add(e.getMessage())) {
            LOG.log(
                    System.Logger.Level.WARNING,
                    "a service is left out, since it cannot be used: " + e.getMessage(),
                    e);
        }
    }

    /** Reports once that a service is left out because another service has the same name. */
    public static void leftOut(Class<?> service, String name, Class<?> other) {
        if (TOLD.add(service.getName() + ' ' + name)) {
            LOG.log(
                    System.Logger.Level.WARNING,
                    service.getName() + " is left out: its name \"" + name + "\" is that of " + other.getName());
        }
    }
}
