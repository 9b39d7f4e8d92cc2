pluginManagement { repositories { mavenCentral() } }

dependencyResolutionManagement {
    repositoriesMode = RepositoriesMode.FAIL_ON_PROJECT_REPOS
    repositories { mavenCentral() }
}

rootProject.name = "argo"

include("javino-java", "argo-filters-dsl", "argo-arch", "samples")
