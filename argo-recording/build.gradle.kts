plugins {
    `java-library`
    alias(libs.plugins.kotlin.serialization)
}

dependencies {
    compileOnly(libs.jason) // the user's project brings Jason
    api(project(":argo-arch"))
    implementation(libs.serialization.json) // what the messages of a recording are written in
    testImplementation(libs.jason)
}

// the newest Jason, for the test that goes through its actions
val newestJason by configurations.creating {
    isCanBeConsumed = false
    isTransitive = false
    attributes {
        attribute(Category.CATEGORY_ATTRIBUTE, objects.named(Category.LIBRARY))
        attribute(Usage.USAGE_ATTRIBUTE, objects.named(Usage.JAVA_RUNTIME))
    }
}
dependencies { newestJason(libs.newest.jason) }

tasks.test {
    dependsOn(newestJason)
    doFirst { systemProperty("newest.jason.jar", newestJason.singleFile.path) }
}
